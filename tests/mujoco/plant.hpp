// A model of MuJoCo and its state.
#pragma once

#include <mujoco/mujoco.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/mujoco/mjcf.hpp"

namespace eagerx::mujoco {

/// An object's description in MuJoCo. The program ends if MuJoCo refuses it.
template <class Description>
class Plant {
 public:
  explicit Plant(const MjcfSettings& settings)
      : model(load(Mjcf<Description>::text(settings))), data(mj_makeData(model)) {}
  Plant(const Plant&) = delete;
  Plant& operator=(const Plant&) = delete;
  ~Plant() {
    mj_deleteData(data);
    mj_deleteModel(model);
  }

  /// Where the joint's number is in qpos, and in qvel and forces; −1 of fixed joints.
  [[nodiscard]] int position_of(std::size_t joint) const {
    const int id = id_of(joint);
    return id < 0 ? -1 : model->jnt_qposadr[id];
  }
  [[nodiscard]] int velocity_of(std::size_t joint) const {
    const int id = id_of(joint);
    return id < 0 ? -1 : model->jnt_dofadr[id];
  }

  mjModel* model;
  mjData* data;

 private:
  [[nodiscard]] int id_of(std::size_t joint) const {
    return mj_name2id(model, mjOBJ_JOINT, Description::kJoints[joint].name);
  }
  static mjModel* load(const std::string& xml) {
    std::FILE* const file = std::tmpfile();  // every version of MuJoCo reads files
    if (file == nullptr || std::fwrite(xml.data(), 1, xml.size(), file) != xml.size() ||
        std::fflush(file) != 0) {
      std::perror("error: cannot write the model of MuJoCo");
      std::exit(2);
    }
    const std::string path = "/proc/self/fd/" + std::to_string(fileno(file));
    char error[1000] = "";
    mjModel* const model = mj_loadXML(path.c_str(), nullptr, error, sizeof error);
    std::fclose(file);
    if (model == nullptr) {
      std::fprintf(stderr, "error: MuJoCo refuses the model: %s\n", error);
      std::exit(2);
    }
    return model;
  }
};

}  // namespace eagerx::mujoco
