"""Tables of the keys of scenario files and of scenes as workers get them, from the schema of `cylon validate --schema`.

Beside the words of JSON Schema it has, for each key, x-form (what the value looks like), x-unit, x-absent (what an absent
key means), x-meaning and x-worker ("always" or "optional" where workers get the key too).
"""
import re


def cell(text):
    """As a cell of a table may hold it: with powers as people write them, and pages as links."""
    text = re.sub(r"docs/([\w-]+\.md)(#[\w-]+)?", r"[\1](\1\2)", text)
    return text.replace("|", "\\|").replace("^2", "²").replace("^3", "³")


def table(head, rows):
    lines = ["| " + " | ".join(row) + " |" for row in (head, *rows)]
    return "\n".join([lines[0], "|---" * len(head) + "|", *lines[1:]])


def number(x):
    return "2⁵³" if x == 2 ** 53 else f"{x:g}"


def unit_and_range(key):
    numbers = (key, key.get("items", {}), *key.get("anyOf", ()))
    bounds = next((n for n in numbers if "minimum" in n or "exclusiveMinimum" in n), {})
    low, above, high = (bounds.get(name) for name in ("minimum", "exclusiveMinimum", "maximum"))
    interval = f"{number(low)} to {number(high)}" if high is not None else \
        f"> {number(above)}" if above is not None else f"≥ {number(low)}" if low is not None else ""
    return ", ".join(filter(None, (key.get("x-unit"), interval)))


def inner(key):
    """The schema of the table, or of each of the tables, that a key holds; nothing where it holds a value."""
    key = key.get("items", key)
    return next((option for option in (key, *key.get("anyOf", ())) if "properties" in option or "oneOf" in option), None)


def keys_of(schema):
    """(type or '', name, schema of the key, required) of every key of a table, type by type."""
    for option in schema.get("oneOf", [schema]):
        kind = option["properties"].get("type", {}).get("const", "")
        for name, key in option["properties"].items():
            if "const" not in key and not name.isdigit():
                yield kind, name, key, name in option.get("required", ())


def types(schema):
    return [option["properties"]["type"]["const"] for option in schema.get("oneOf", ())]


def key_row(name, key, required):
    """Key, value, unit and range, default, meaning."""
    words = ", ".join(f"`{word}`" for word in key.get("enum", ()))
    return (f"**`{name}`**" if required else f"`{name}`", words or re.sub("^an? ", "", key["x-form"]),
            *map(cell, (unit_and_range(key), key.get("x-absent", ""), key.get("x-meaning", ""))))


def key_tables(title, schema, told):
    """A table of keys under its title, then those of the tables inside; rows that are `told` already are left out."""
    rows, tables = {}, {}
    for kind, *of_key in keys_of(schema):
        if (row := key_row(*of_key)) not in told:
            rows.setdefault(row, []).append(kind)
            tables[of_key[0]] = of_key[1]
    head = ["key", "value", "unit, range", "default", "meaning"]
    if kinds := types(schema):
        lines = [["all", "**`type`**", ", ".join(f"`{kind}`" for kind in kinds), "", "", "Selects the other keys."]]
        lines += [["all" if of == kinds else ", ".join(f"`{kind}`" for kind in of), *row] for row, of in rows.items()]
        yield f"{title}\n\n{table(['type', *head], lines)}"
    else:
        yield f"{title}\n\n{table(head, rows)}"
    for name, key in tables.items():
        if inner(key) and any(keys_of(inner(key))):
            yield from key_tables(f"**`{name}`**: {cell(key['x-meaning'])}", inner(key), {*told, *rows})


def scene_keys(schema):
    """Every key of a scenario file, table by table."""
    elements = {name: key for name, key in schema["properties"].items() if inner(key)}
    plain = {name: key for name, key in schema["properties"].items() if name not in elements}
    tables = [*key_tables("**The scenario**", {**schema, "properties": plain}, ())]
    of_body = {key_row(*of_key) for _, *of_key in keys_of(inner(elements["body"]))}
    for name, key in elements.items():
        label = f"[[{name}]]" if key["type"] == "array" else f"[{name}]"
        told = of_body if name in ("lattice", "cloud") else ()
        tables += key_tables(f"**`{label}`**: {cell(key['x-meaning'])}", inner(key), told)
    return "\n\n".join(tables)


def worker_key(name, key):
    """`anchor` [m] *opt*: On the body, body axes."""
    unit = f" [{key['x-unit']}]" if "x-unit" in key else ""
    optional = " *opt*" if key["x-worker"] == "optional" else ""
    words = f" ({', '.join(key['enum'])})" if "enum" in key else ""
    meaning = f": {key['x-meaning']}" if key.get("x-meaning") else ""
    return cell(f"`{name}`{unit}{optional}{words}{meaning}")


def worker_keys(schema):
    """The elements of a scene as workers get them: the keys of each, whatever its type."""
    rows = []
    for name, key in schema["properties"].items():
        if inner(key) and "x-worker" in key:
            keys = {"type": f"`type` ({', '.join(types(inner(key)))})"} if types(inner(key)) else {}
            keys |= {k: worker_key(k, of) for _, k, of, _ in keys_of(inner(key)) if "x-worker" in of}
            optional = " *opt*" if key["x-worker"] == "optional" else ""
            rows.append([f"`{name}`{optional}", "<br>".join(keys.values()), cell(key["x-meaning"])])
    return table(["list", "keys of an element", "meaning"], rows)


def worker_shapes(schema):
    """The keys of each shape as workers get them."""
    body = inner(schema["properties"]["body"])
    keys = {}
    for kind, name, key, _ in keys_of(inner(body["properties"]["shape"])):
        if "x-worker" in key:
            keys.setdefault(kind, []).append(worker_key(name, key))
    return table(["`type`", "keys"], [[f"`{kind}`", "<br>".join(of)] for kind, of in keys.items()])
