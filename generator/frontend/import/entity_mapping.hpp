// Maps EAGERx's entities and their parameters to ours, through the manifests.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "generator/frontend/import/saved.hpp"
#include "generator/frontend/library/library.hpp"

namespace eagerx::gen {

/// The use of an entity of EAGERx.
enum class Use : std::uint8_t { engine, node, object, processor, engine_node, engine_state };

/// An entity of EAGERx without a counterpart.
struct Missing {
  Use use = Use::node;
  std::vector<std::pair<std::string, Span>> users;
  bool other_parameters = false;  // there is one, for other values of its parameters
  /// Its interface as saved, of the first user.
  SavedEntity saved;
};

class EntityMapping {
 public:
  EntityMapping(const Library& library, Diagnostics& diagnostics)
      : library_(library), diagnostics_(diagnostics) {}

  /// Our entity for `id` with these parameters, or nullptr. `user`: the element that needs it, for
  /// messages ("the node `smooth`").
  const Entity* find(const Spanned<std::string>& id, const YamlValue& config, Use use,
                     const std::string& user);
  /// The same without a message if there is none.
  [[nodiscard]] const Entity* look_up(const std::string& id, const YamlValue& config,
                                      Use use) const;
  /// As find(), and keeps the interface for missing().
  const Entity* require(const SavedEntity& saved, Use use, const std::string& user);
  /// Whether any of our entities corresponds to this one of EAGERx.
  [[nodiscard]] bool knows(const std::string& id) const;
  /// A class of `__main__` can be from any script: our entity of that name may replace it if ports,
  /// their spaces and parameters are the same, with a warning (E0806); otherwise E0801 and false. A
  /// user's own entity always may.
  bool may_stand_in(const Entity& entity, const SavedEntity& saved, const std::string& user);
  /// Whether our entity corresponds to this one of EAGERx, with any parameters.
  [[nodiscard]] static bool stands_for(const Entity& entity, const std::string& id);

  /// Our parameters, without those that have their default. Parameters that our entity lacks are
  /// noted; `user` as above.
  std::vector<Setting> settings(const Entity& entity, const YamlValue& config,
                                const std::string& user);
  /// The processor of a port, if it has one.
  std::optional<ProcessorSpec> processor(const SavedPort& port, const std::string& user);

  /// Reports every requested id without a counterpart once (E0801).
  void report_missing();
  /// By EAGERx's id.
  [[nodiscard]] const std::map<std::string, Missing>& missing() const { return missing_; }
  [[nodiscard]] bool any_missing() const { return !missing_.empty(); }
  [[nodiscard]] const Library& library() const { return library_; }

 private:
  struct Choice {
    const Entity* best = nullptr;
    bool known = false, ambiguous = false;
  };
  [[nodiscard]] Choice choose(const std::string& id, const YamlValue& config, Use use) const;

  const Library& library_;
  Diagnostics& diagnostics_;
  std::map<std::string, Missing> missing_;
  std::set<std::string> reported_;  // about stand-ins
};

/// Every entity that the file needs, those inside objects that are not known too.
void require_all(const SavedGraph& saved, EntityMapping& mapping);

const char* to_string(Use use);

/// Parameters that EAGERx writes for every entity.
bool is_common_parameter(std::string_view name);

/// Whether two values are the same: 1 and 1.0, [0] and 0.
bool same_value(const YamlValue& a, const YamlValue& b);

}  // namespace eagerx::gen
