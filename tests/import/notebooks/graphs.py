"""The graphs of EAGERx's tutorials (eagerx_tutorials/tutorials) as Graph.save writes them, rebuilt from the notebooks'
description: graphs() gives name → tree. `pendulum_N` is the graph of notebook N, `pendulum_solutions_N` that of its
exercises."""

PENDULUM = "eagerx_tutorials.pendulum.objects/Pendulum"
RENDER = "eagerx.core.nodes/RenderNode"
PI_F32 = 3.1415927410125732


def space(shape=(), low=None, high=None, dtype="float32"):
    return {"dtype": dtype, "high": high, "low": low, "shape": list(shape)}


ANGLE, VOLTAGE = space((), -999.0, 999.0), space([1], -2.0, 2.0)
PICTURE = space([480, 480, 3], 0, 255, "uint8")
STATE = space([2], [-3.140000104904175, -9.0], [3.140000104904175, 9.0])
MODEL_PARAMETERS = [0.00015993145643733442, 0.05085817351937294, 0.041523370891809464, 1.4329848454508465e-05,
                    0.03333911672234535, 7.731251239776611, 0.0009750411845743656, 165.41795349121094]


def taken(of, window=1, delay=0.0, skip=False, processor=None):
    """An input, actuator or feedthrough."""
    return {"address": None, "delay": delay, "processor": processor, "skip": skip, "space": of, "window": window}


def given(of, rate="$(config rate)", processor=None):
    return {"processor": processor, "rate": rate, "space": of}


def named(**ports):
    return {name: {"processor": None, "space": of} for name, of in ports.items()}


def node(kind, rate, inputs, outputs, config=None, **sections):
    """Of a graph; `sections`: feedthroughs, targets, states."""
    selected = {"targets": list(sections["targets"])} if "targets" in sections else {}
    return {"config": {"color": "grey", "entity_id": kind, "executable": "python:=eagerx.core.executable_node",
                       "inputs": list(inputs), "log_level": 30, "log_level_memory": 0, "outputs": list(outputs),
                       "process": 1, "rate": rate, "states": list(sections.get("states", {}))} | selected | (config or {}),
            "inputs": inputs, "node_type": kind, "outputs": outputs, "states": {}} | sections


def thing(kind, sensors, actuators, states, selected, config=None):
    """An object; `selected`: sensors and states."""
    return {"actuators": actuators, "entity_type": kind, "sensors": sensors, "states": states,
            "config": {"actuators": list(actuators), "entity_id": kind, "sensors": selected[0], "states": selected[1]} | (config or {})}


def pendulum(sensors=("theta", "theta_dot", "image"), states=("model_state",), rate=30.0, kind=PENDULUM, theta=None, more=None):
    """`more`: sensors that the notebook adds, instead of those that its class does not have."""
    known = {"image": given(PICTURE, 15.0), "theta": theta or given(ANGLE, rate), "theta_dot": given(ANGLE, rate)}
    known |= more if more is not None else {"u_applied": given(VOLTAGE, rate)}
    all_states = named(model_state=STATE)
    if kind == PENDULUM:
        all_states |= named(length=space((), 0.04, 0.2), mass=space((), 0.01, 0.07), max_speed=space((), 22.0, 22.0),
                            model_parameters=space([8], MODEL_PARAMETERS, MODEL_PARAMETERS))
    return thing(kind, known, {"u": taken(VOLTAGE) | {"rate": rate}}, all_states, [list(sensors), list(states)],
                 {"render_fn": "pendulum_render_fn", "render_shape": [480, 480]})


def graph(nodes, connects, action, observations):
    """`connects`: "pendulum.sensors.theta > environment.inputs.angle"; `observations`: name → input."""
    nodes = dict(nodes)
    nodes["environment"] = node("eagerx.core.nodes/EnvNode", None, observations, {action[0]: given(action[1])}, {"color": "yellow"})
    for name, item in nodes.items():
        item["config"]["name"] = name
    links = [[end.strip().split(".") for end in line.split(">")] for line in connects.strip().splitlines()]
    return {"backup": nodes, "connects": links, "engine_id": None, "gui_state": {}, "nodes": nodes}


LINKS = """environment.outputs.voltage > pendulum.actuators.u
pendulum.sensors.theta > environment.inputs.angle
pendulum.sensors.theta_dot > environment.inputs.angular_velocity"""
RENDERED = "\npendulum.sensors.image > env/render.inputs.image"


def swing_up(nodes, links=LINKS, observations=None, rendered=True):
    """Voltage to angle and angular velocity, as all notebooks of the pendulum begin."""
    observations = {"angle": taken(ANGLE), "angular_velocity": taken(ANGLE)} | (observations or {})
    observations = {name: value for name, value in observations.items() if value}
    if rendered:
        nodes = nodes | {"env/render": node(RENDER, 30.0, {"image": taken(PICTURE)}, {"done": given(space((), 0, 1, "int64"))}, {"display": True, "encoding": "bgr"})}
        links += RENDERED if "env/render" not in links else ""
    return graph(nodes, links, ("voltage", VOLTAGE), observations)


def normalised():
    return swing_up({"pendulum": pendulum(theta=given(space((), -PI_F32, PI_F32), 30.0, {"dtype": "float32", "processor_type": "__main__/WrappingProcessor"}))})


def on_circle():
    circle = space([2], -1.0, 1.0)
    theta = given(circle, 30.0, {"processor_type": "__main__/DecomposeAngle"})
    return swing_up({"pendulum": pendulum(theta=theta)}, observations={"angle": taken(circle)})


def filtered(observed):
    average = node("__main__/MovingAverageFilter", 30, {"signal": taken(space([1], -3.0, 3.0))}, {"filtered": given(space([1], -3.0, 3.0))}, {"n": 10} if observed else {})
    links = LINKS.replace("> pendulum.actuators.u", "> moving_average.inputs.signal") + "\nmoving_average.outputs.filtered > pendulum.actuators.u"
    seen = {"filtered_voltage": taken(space([1], -3.0, 3.0), skip=True)} if observed else {}
    links += "\nmoving_average.outputs.filtered > environment.inputs.filtered_voltage" if observed else ""
    return swing_up({"pendulum": pendulum(), "moving_average": average}, links, seen)


def own_object(solved):
    array = {"x": given(space([2], -999.0, 999.0), 30.0)} if solved else {}
    if not solved:
        return swing_up({"pendulum": pendulum(kind="__main__/Pendulum", more=array)})
    links = "environment.outputs.voltage > pendulum.actuators.u\npendulum.sensors.x > environment.inputs.x"
    seen = {"angle": None, "angular_velocity": None, "x": taken(space([2], -999.0, 999.0))}
    return swing_up({"pendulum": pendulum(("x", "image"), kind="__main__/Pendulum", more=array)}, links, seen)


def overlay(solved):
    inputs = {"base_image": taken(PICTURE), "u": taken(VOLTAGE)} | ({"theta": taken(ANGLE)} if solved else {})
    kind = "eagerx_tutorials.pendulum.overlay/Overlay" if solved else "__main__/Overlay"
    links = LINKS + """
pendulum.sensors.image > overlay.inputs.base_image
environment.outputs.voltage > overlay.inputs.u
overlay.outputs.image > env/render.inputs.image""" + ("\npendulum.sensors.theta > overlay.inputs.theta" if solved else "")
    return swing_up({"pendulum": pendulum(), "overlay": node(kind, 20, inputs, {"image": given(PICTURE)})}, links)


def reset_angle(solved):
    config = {"duration": 2.0, "u_range": [-2.0, 2.0]} if solved else {"gains": [2.0, 0.2, 1.0], "threshold": 0.1, "timeout": 5.0, "u_range": [-2.0, 2.0]}
    routine = node("__main__/ResetAngle", 30.0, {"theta": taken(space()), "theta_dot": taken(space())}, {"u": given(VOLTAGE)}, config,
                   feedthroughs={"u": taken({"dtype": "float32", "high": None, "low": None, "shape": None})}, targets=named(goal=STATE))
    links = LINKS.replace("> pendulum.actuators.u", "> reset_angle.feedthroughs.u") + """
pendulum.states.model_state > reset_angle.targets.goal
reset_angle.outputs.u > pendulum.actuators.u
pendulum.sensors.theta > reset_angle.inputs.theta
pendulum.sensors.theta_dot > reset_angle.inputs.theta_dot"""
    return swing_up({"pendulum": pendulum(), "reset_angle": routine}, links)


def transfer():
    circle = space([2], -1.0, 1.0)
    theta = given(circle, 20, {"convert_to": "trig_vec", "processor_type": "eagerx_tutorials.pendulum.processor/DecomposedAngle"})
    return swing_up({"pendulum": pendulum(states=("model_state", "mass", "length", "max_speed"), rate=20, theta=theta)}, observations={"angle": taken(circle)})


def quadruped():
    def box(size):
        return space([size], [-1.0] * size, [1.0] * size)
    sizes = {"joint_position": 12, "joint_velocity": 12, "force_torque": 24, "orientation": 4, "position": 3, "velocity": 3}
    go1 = thing("eagerx_tutorials.quadruped.object/Quadruped", {name: given(box(size), 20) for name, size in sizes.items()},
                {"joint_control": taken(box(12)) | {"rate": 20}}, named(joint_position=box(12), position=box(3), orientation=box(4)),
                [["position", "velocity", "joint_position"], ["joint_position", "position"]], {"control_mode": "position_control"})
    gait = node("eagerx_tutorials.quadruped.cpg_gait/CpgGait", 20, {"offset": taken(box(4))}, {"cartesian_pos": given(box(12)), "xs_zs": given(box(24))}, {"gait": "TROT", "omega_swing": 16.0})
    feet = node("eagerx_tutorials.quadruped.cartesian_control/CartesiandPDController", 20, {"cartesian_pos": taken(box(12))}, {"joint_pos": given(box(12))})
    plane = node("eagerx_tutorials.quadruped.overlay/XyPlane", 8, {"position": taken(box(3), window=0)}, {"image": given(PICTURE)})
    render = node(RENDER, 8, {"image": taken(PICTURE)}, {"done": given(space((), 0, 1, "int64"))}, {"display": True, "encoding": "bgr"})
    return graph({"quadruped": go1, "cpg_gait": gait, "cartesian_control": feet, "xy_plane": plane, "env/render": render}, """
environment.outputs.offset > cpg_gait.inputs.offset
cpg_gait.outputs.cartesian_pos > cartesian_control.inputs.cartesian_pos
cartesian_control.outputs.joint_pos > quadruped.actuators.joint_control
quadruped.sensors.position > environment.inputs.position
quadruped.sensors.velocity > environment.inputs.velocity
cpg_gait.outputs.xs_zs > environment.inputs.xs_zs
quadruped.sensors.position > xy_plane.inputs.position
xy_plane.outputs.image > env/render.inputs.image""", ("offset", box(4)), {"position": taken(box(3)), "velocity": taken(box(3)), "xs_zs": taken(box(24), skip=True)})


def graphs():
    applied = swing_up({"pendulum": pendulum(("theta", "u_applied", "image"), ("model_state", "model_parameters"))},
                       LINKS.rsplit("\n", 1)[0] + "\npendulum.sensors.u_applied > environment.inputs.voltage_applied",
                       {"angle": taken(ANGLE, window=3, delay=0.01), "angular_velocity": None, "voltage_applied": taken(VOLTAGE)})
    plain = swing_up({"pendulum": pendulum()})
    return {
        "pendulum_1_environment_creation": plain,
        "pendulum_2_reset_and_step": swing_up({"pendulum": pendulum(states=("model_state", "model_parameters"))}),
        "pendulum_3_space_and_processors": normalised(),
        "pendulum_4_nodes": filtered(observed=False),
        "pendulum_5_engine_implementation": plain,
        "pendulum_6_objects": own_object(solved=False),
        "pendulum_7_rendering": overlay(solved=False),
        "pendulum_8_reset_routine": reset_angle(solved=False),
        "pendulum_solutions_2_reset_and_step": applied,
        "pendulum_solutions_3_space_and_processors": on_circle(),
        "pendulum_solutions_4_nodes": filtered(observed=True),
        "pendulum_solutions_5_engine_implementation": plain,
        "pendulum_solutions_6_objects": own_object(solved=True),
        "pendulum_solutions_7_rendering": overlay(solved=True),
        "pendulum_solutions_8_reset_routine": reset_angle(solved=True),
        "icra_1_getting_started": transfer(),
        "icra_2_advanced_usage": quadruped(),
    }
