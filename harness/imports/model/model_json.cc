#include "harness/imports/model/model_json.h"

#include <type_traits>

namespace cylon::foreign {
namespace {

using Json = nlohmann::json;

template <class E, class T>
concept Of = std::is_same_v<std::remove_const_t<E>, T>;

// members: calls visit(key, member) for each member of an element; the same table reads and writes.
template <Of<Place> E>
void members(E& e, const auto& visit) {
  visit("element", e.element), visit("file", e.file), visit("line", e.line);
}
template <Of<Pose> E>
void members(E& e, const auto& visit) {
  visit("position", e.position), visit("turn", e.turn);
}
template <Of<Solid> E>
void members(E& e, const auto& visit) {
  visit("place", e.place), visit("kind", e.kind), visit("size", e.size), visit("vertices", e.vertices);
  visit("faces", e.faces), visit("pose", e.pose), visit("surface", e.surface);
}
template <Of<Body> E>
void members(E& e, const auto& visit) {
  visit("place", e.place), visit("name", e.name), visit("mass", e.mass), visit("inertia", e.inertia);
  visit("pose", e.pose), visit("velocity", e.velocity), visit("spin", e.spin), visit("locked", e.locked);
  visit("gravity", e.gravity), visit("linear_drag", e.linear_drag), visit("angular_drag", e.angular_drag);
  visit("solids", e.solids);
}
template <Of<Freedom> E>
void members(E& e, const auto& visit) {
  visit("kind", e.kind), visit("axis", e.axis), visit("pitch", e.pitch), visit("start", e.start);
  visit("lower", e.lower), visit("upper", e.upper), visit("stiffness", e.stiffness), visit("rest", e.rest);
  visit("damping", e.damping), visit("friction", e.friction), visit("force", e.force);
  visit("armature", e.armature), visit("moved", e.moved);
}
template <Of<Joint> E>
void members(E& e, const auto& visit) {
  visit("place", e.place), visit("name", e.name), visit("body", e.body), visit("to", e.to);
  visit("point", e.point), visit("offset", e.offset), visit("freedoms", e.freedoms),
      visit("one_body", e.one_body);
  visit("may_touch", e.may_touch);
}
template <Of<Meeting> E>
void members(E& e, const auto& visit) {
  visit("a", e.a), visit("b", e.b), visit("friction", e.friction), visit("restitution", e.restitution);
}
template <Of<Loss> E>
void members(E& e, const auto& visit) {
  visit("what", e.what), visit("place", e.place), visit("detail", e.detail);
}
template <Of<Model> E>
void members(E& e, const auto& visit) {
  visit("library", e.library), visit("gravity", e.gravity), visit("step", e.step), visit("bodies", e.bodies);
  visit("joints", e.joints), visit("meetings", e.meetings), visit("losses", e.losses);
}

// ---- Values ---------------------------------------------------------------------------------------

template <class T>
struct Value {  // numbers, texts and flags are the library's own
  static Json written(const T& value) { return value; }
  static void read(const Json& json, T& value) { json.get_to(value); }
};
template <class T>
requires requires(T& e) {
  members(e, [](const char*, const auto&) {});
}
struct Value<T> {
  static Json written(const T& element) {
    Json json = Json::object();
    members(element,
            [&]<class M>(const char* key, const M& member) { json[key] = Value<M>::written(member); });
    return json;
  }
  static void read(const Json& json, T& element) {
    members(element, [&]<class M>(const char* key, M& member) { Value<M>::read(json.at(key), member); });
  }
};
template <class T>
struct Value<std::vector<T>> {
  static Json written(const std::vector<T>& values) {
    Json json = Json::array();
    for (const T& value : values) json.push_back(Value<T>::written(value));
    return json;
  }
  static void read(const Json& json, std::vector<T>& values) {
    values.clear();
    for (const Json& value : json) Value<T>::read(value, values.emplace_back());
  }
};
template <class T>
struct Value<std::optional<T>> {
  static Json written(const std::optional<T>& value) { return value ? Value<T>::written(*value) : Json(); }
  static void read(const Json& json, std::optional<T>& value) {
    value.reset();
    if (!json.is_null()) Value<T>::read(json, value.emplace());
  }
};
template <>
struct Value<Vector3> {
  static Json written(const Vector3& v) { return {v.x(), v.y(), v.z()}; }
  static void read(const Json& json, Vector3& v) {
    v = {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
  }
};
template <>
struct Value<Quaternion> {
  static Json written(const Quaternion& q) { return {q.w(), q.x(), q.y(), q.z()}; }
  static void read(const Json& json, Quaternion& q) {
    q = Quaternion(json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>(),
                   json.at(3).get<double>());
  }
};
template <>
struct Value<Matrix3> {
  static Json written(const Matrix3& m) {
    Json json = Json::array();
    for (const double x : m.reshaped<Eigen::RowMajor>()) json.push_back(x);
    return json;
  }
  static void read(const Json& json, Matrix3& m) {
    for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = json.at(static_cast<std::size_t>(i)).get<double>();
  }
};

}  // namespace

nlohmann::json to_json(const Model& model) { return Value<Model>::written(model); }

Model from_json(const nlohmann::json& json) {
  Model model;
  Value<Model>::read(json, model);
  return model;
}

}  // namespace cylon::foreign
