// A model of MuJoCo and its state.
#pragma once

#include <mujoco/mujoco.h>
#include <unistd.h>

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
    char path[] = "/tmp/eagerx_mjcf_XXXXXX";
    const int file = mkstemp(path);
    if (file < 0 || write(file, xml.data(), xml.size()) != static_cast<ssize_t>(xml.size())) {
      std::perror(path);
      std::exit(2);
    }
    close(file);
    char error[1000] = "";
    mjModel* const model = mj_loadXML(path, nullptr, error, sizeof error);
    unlink(path);
    if (model == nullptr) {
      std::fprintf(stderr, "error: MuJoCo refuses the model: %s\n", error);
      std::exit(2);
    }
    return model;
  }
};

}  // namespace eagerx::mujoco
