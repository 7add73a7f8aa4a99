// The filter's language: terms, and (or nothing between terms), or, not, parentheses.  What a term means
// stands in match.ts.

export type Field = 'scenario' | 'tag' | 'claim';
export type Relation = '<' | '<=' | '>' | '>=' | '=';

export type Query =
  | { kind: 'all' }
  | { kind: 'and' | 'or'; parts: Query[] }
  | { kind: 'not'; part: Query }
  | { kind: 'word'; text: string }
  | { kind: 'field'; field: Field; glob: string }
  | { kind: 'status'; engine: string; status: string }
  | { kind: 'digits'; engine: string; relation: Relation; value: number };

export interface Parsed {
  query: Query;
  columns: string[]; // globs of the columns to show; empty: all
  engines: Named[]; // that terms speak of, any of them aside
}

/** A name in a query, and where it stands. */
export interface Named {
  name: string;
  at: number;
}

/** A query that is none: what is wrong, and from which character on. */
export class QueryError extends Error {
  constructor(
    message: string,
    readonly at: number,
    readonly length: number,
  ) {
    super(message);
  }
}

interface Token {
  text: string;
  at: number;
  quoted: boolean;
}

const conditions = [
  'pass',
  'low-quality',
  'fail',
  'undecided',
  'unsupported',
  'crash',
  'timeout',
  'non-finite',
  'protocol',
  'differs',
  'expected',
  'none',
];
const fields: Field[] = ['scenario', 'tag', 'claim'];

function tokens(text: string): Token[] {
  const out: Token[] = [];
  let at = 0;
  while (at < text.length) {
    const c = text[at]!;
    if (/\s/.test(c)) {
      ++at;
    } else if (c === '(' || c === ')') {
      out.push({ text: c, at: at++, quoted: false });
    } else {
      const token = word(text, at);
      out.push(token);
      at += token.length;
    }
  }
  return out;
}

/** Up to a blank or parenthesis; within double quotes both are letters. */
function word(text: string, start: number): Token & { length: number } {
  let at = start;
  let out = '';
  let opened = -1;
  for (; at < text.length; ++at) {
    const c = text[at]!;
    if (c === '"') opened = opened < 0 ? at : -1;
    else if (opened < 0 && /[\s()]/.test(c)) break;
    else out += c;
  }
  if (opened >= 0) throw new QueryError('this quote is never closed', opened, text.length - opened);
  return { text: out, at: start, quoted: text[start] === '"', length: at - start };
}

/** Edit distance, for "did you mean". */
export function distance(a: string, b: string): number {
  let row = Array.from({ length: b.length + 1 }, (_, j) => j);
  for (let i = 1; i <= a.length; ++i) {
    const next = [i];
    for (let j = 1; j <= b.length; ++j)
      next.push(Math.min(next[j - 1]! + 1, row[j]! + 1, row[j - 1]! + Number(a[i - 1] !== b[j - 1])));
    row = next;
  }
  return row[b.length]!;
}

const deepest = 100;

class Parser {
  private next = 0;
  private depth = 0;
  readonly columns: string[] = [];
  readonly engines: Named[] = [];

  constructor(
    private readonly list: Token[],
    private readonly end: number,
  ) {}

  whole(): Query {
    if (this.list.length === 0) return { kind: 'all' };
    const query = this.either();
    const left = this.list[this.next];
    if (left) throw new QueryError('this closes nothing', left.at, 1);
    return query;
  }

  private is(text: string): boolean {
    const token = this.list[this.next];
    return token !== undefined && !token.quoted && token.text.toLowerCase() === text;
  }

  private take(text: string): boolean {
    if (!this.is(text)) return false;
    ++this.next;
    return true;
  }

  private either(): Query {
    const first = this.list[this.next];
    const before = this.columns.length;
    const parts = [this.both()];
    while (this.is('or')) {
      if (this.columns.length > before) throw misplaced(first!);
      this.nested(() => (++this.next, parts.push(this.both())));
    }
    return parts.length === 1 ? parts[0]! : { kind: 'or', parts };
  }

  private both(): Query {
    const parts = [this.single()];
    while (this.next < this.list.length && !this.is('or') && !this.is(')')) {
      this.take('and');
      parts.push(this.single());
    }
    const asking = parts.filter(({ kind }) => kind !== 'all'); // columns: asks nothing of a row
    return asking.length > 1 ? { kind: 'and', parts: asking } : (asking[0] ?? { kind: 'all' });
  }

  private single(): Query {
    const token = this.list[this.next];
    if (!token) throw new QueryError('a term is missing here', this.end, 1);
    if (this.take('not')) return { kind: 'not', part: this.nested(() => this.single()) };
    if (this.take('(')) {
      const query = this.nested(() => this.either());
      if (!this.take(')')) throw new QueryError('this parenthesis is never closed', token.at, 1);
      return query;
    }
    if (this.is(')') || this.is('and') || this.is('or'))
      throw new QueryError(`a term is missing before '${token.text}'`, token.at, token.text.length);
    ++this.next;
    return this.term(token);
  }

  private nested<T>(parse: () => T): T {
    if (++this.depth > deepest)
      throw new QueryError(`nested deeper than ${deepest}`, this.list[this.next - 1]!.at, 1);
    const out = parse();
    --this.depth;
    return out;
  }

  private term(token: Token): Query {
    const text = token.text.toLowerCase();
    if (token.quoted) return { kind: 'word', text };
    const measured = /^(?:(.*):)?digits(<=|>=|<|>|=)(.*)$/.exec(text);
    if (measured) return this.digits(token, measured[1] ?? '*', measured[2] as Relation, measured[3]!);
    if (text.endsWith(':')) throw new QueryError(`nothing stands after '${text}'`, token.at, text.length);
    if (text.startsWith('columns:')) return this.show(token, text.slice('columns:'.length));
    const field = fields.find((f) => text.startsWith(`${f}:`));
    if (field) return { kind: 'field', field, glob: text.slice(field.length + 1) };
    const colon = text.lastIndexOf(':'); // an engine's name may have some
    if (colon < 0) return { kind: 'word', text };
    const before = text.slice(0, colon);
    const after = text.slice(colon + 1);
    if (before === '') throw new QueryError('an engine is missing before the colon', token.at, text.length);
    if (!conditions.includes(after)) throw new QueryError(unknown(after), token.at + colon + 1, after.length);
    return { kind: 'status', engine: this.engine(before, token.at), status: after };
  }

  private digits(token: Token, engine: string, relation: Relation, number: string): Query {
    const value = Number(number);
    if (number === '' || !Number.isFinite(value)) {
      const at = token.at + token.text.length - number.length;
      throw new QueryError(`a number must follow, not '${number}'`, at, Math.max(1, number.length));
    }
    return { kind: 'digits', engine: this.engine(engine, token.at), relation, value };
  }

  private engine(name: string, at: number): string {
    if (name === 'any' || name === '*') return '*';
    this.engines.push({ name, at });
    return name;
  }

  private show(token: Token, globs: string): Query {
    if (this.depth > 0) throw misplaced(token);
    this.columns.push(...globs.split(',').filter((glob) => glob !== ''));
    return { kind: 'all' };
  }
}

function misplaced(token: Token): QueryError {
  const message = "columns: says what is shown; it cannot stand within 'or', 'not' or parentheses";
  return new QueryError(message, token.at, token.text.length);
}

function unknown(condition: string): string {
  const near = conditions.filter((c) => distance(c, condition) <= 2)[0];
  const hint = near ? `did you mean '${near}'?` : `there are ${conditions.join(', ')}`;
  return `no status is called '${condition}': ${hint}`;
}

/** Throws QueryError. */
export function parse(text: string): Parsed {
  const parser = new Parser(tokens(text), text.length);
  const query = parser.whole();
  return { query, columns: parser.columns, engines: parser.engines };
}
