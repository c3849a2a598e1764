// Checks parameters against their manifest, and resolves the `$(…)` that manifests may write
// instead of numbers.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "generator/frontend/library/library.hpp"
#include "generator/frontend/spec/dtype.hpp"
#include "generator/frontend/spec/reference.hpp"

namespace eagerx::gen {

struct ModelUse;

/// A parameter's value, checked against its manifest.
struct ConfigValue {
  const Parameter* parameter = nullptr;
  std::variant<std::int64_t, double, bool, std::string, std::vector<std::int64_t>,
               std::vector<double>, std::shared_ptr<const ModelUse>>
      value;
  bool given = false;  // false: the manifest's default
  Span span{};         // where it was given, else where it could have been
};
using Config = std::vector<ConfigValue>;  // in the order of the manifest

/// An object as a parameter: its model on one engine, without the object.
struct ModelUse {
  const Entity* object = nullptr;
  const ObjectEngine* implementation = nullptr;
  Config config;  // of the object
};

/// The meaning of `$(…)` at one place.
using References = std::map<Reference, YamlValue>;

/// Checks `settings` against the parameters and fills in defaults; problems are reported (E0320
/// unknown, E0321 missing, E0322 wrong type, E0323 out of range, and for an object as a parameter
/// those of entities). `span`: the place of a missing one. `outside`: the references for `$(…)` in
/// a default.
Config resolve_config(const Library& library, const Entity& entity,
                      const std::vector<Setting>& settings, Span span, Diagnostics& diagnostics,
                      const References& outside = {});

/// The value of a parameter that is an object with a model for the parameter's engine; nullptr
/// after a problem (those of entities, of their parameters, and of the form of the value).
std::shared_ptr<const ModelUse> read_model(const Library& library, const Parameter& parameter,
                                           const YamlValue& yaml, Diagnostics& diagnostics);

/// A value whose unit is written, in the unit of the parameter: `10 ms` for a parameter in s is
/// 0.01.
YamlValue in_unit_of(const Parameter& parameter, YamlValue yaml);

/// The references that a config gives rise to: `config NAME` for every parameter.
References references_of(const Entity& entity, const std::vector<Setting>& settings);

/// `yaml` with every `$(…)` replaced; an unknown reference is reported (E0324) and marked, so that
/// it causes no further messages.
bool is_unresolved(const YamlValue& yaml);
YamlValue substitute(YamlValue yaml, const References& references, Diagnostics& diagnostics);
std::vector<Setting> substitute(std::vector<Setting> settings, const References& references,
                                Diagnostics& diagnostics);

/// The number, or the result of the expression; unresolved after a problem.
YamlValue value_of(const QuantitySpec& quantity, const References& references,
                   Diagnostics& diagnostics);

/// A number or list of numbers as doubles; nullopt (and E0322) if it is something else.
std::optional<std::vector<double>> numbers_of(const YamlValue& yaml, Diagnostics& diagnostics);

/// Whether doubles represent the whole numbers of `yaml` exactly: spaces and states store doubles,
/// which have 53 bits. Without a dtype, it may be an integer. Reports error `code` at the first
/// number that is not exact.
bool are_exact_as_doubles(const YamlValue& yaml, std::optional<Dtype> dtype, const char* code,
                          Diagnostics& diagnostics);

/// A rate in Hz, with references replaced; nullopt (and E0204) if it is no positive number.
std::optional<Rational> rate_of(const QuantitySpec& rate, const References& references,
                                Diagnostics& diagnostics);

/// The entity with this id if it has the required kind, otherwise nullptr and E0303 (unknown) or
/// E0304 (other kind); no message for an empty id. `instead`: the help for another kind, if the id
/// is not in an entry of the graph.
const Entity* find_entity(const Library& library, const Spanned<std::string>& id, EntityKind kind,
                          Diagnostics& diagnostics, const std::string& instead = {});

/// How an object is made on an engine; E0308 if it is not, with the help `instead` if the engine is
/// not the graph's.
const ObjectEngine* find_implementation(const Library& library, const Entity& entity,
                                        const Entity& engine, Span span, Diagnostics& diagnostics,
                                        const std::string& instead = {});

}  // namespace eagerx::gen
