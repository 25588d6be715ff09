"""The models of the gallery by name: the function that makes each, and the ending of its file."""
import boards
import bodies
import craft
import machines
import plates

MODELS = {
    "plate_triangular_hole": (plates.plate_triangular_hole, ".step"),
    "plate_small_holes": (plates.plate_small_holes, ".step"),
    "pyramid_on_block": (bodies.pyramid_on_block, ".step"),
    "reflectarray": (boards.reflectarray, ".brep"),
    "microstrip_filter": (boards.microstrip_filter, ".step"),
    "truncated_cone_sphere": (bodies.truncated_cone_sphere, ".step"),
    "conesphere_slot": (bodies.conesphere_slot, ".step"),
    "satellite": (machines.satellite, ".step"),
    "armoured_vehicle": (machines.armoured_vehicle, ".step"),
    "airplane": (craft.airplane, ".step"),
    "drone": (craft.drone, ".step"),
}
