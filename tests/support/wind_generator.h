// The example model Resources/examples/wind_generator.brep.
#pragma once

class TopoDS_Shape;

/// A wind generator as one closed solid, in mm: conical tower 24 m high on the plane z = 0, nacelle, shaft, spinner and
/// three twisted blades 11 m long. The rotor turns about the x axis of its hub. Throws Standard_Failure.
TopoDS_Shape wind_generator();
