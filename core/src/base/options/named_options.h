// Media, ports and wires from text.
#pragma once

#include <optional>
#include <string>

#include "paver/options.h"

namespace paver {

/// "FR4=Solid1,Solid2,eps-r:4.4,mu-r:1,tan-d:0.02", "Metal=Solid2,conductor". Names of parts and ranges are left to
/// check(Options). Nothing for text of another form.
std::optional<Medium> parse_medium(const std::string& text);

/// "Feed=Edge5,Face3".
std::optional<Port> parse_port(const std::string& text);

/// "Mast=Edge5,radius:0.5mm".
std::optional<Wire> parse_wire(const std::string& text);

inline constexpr const char* medium_example = "FR4=Solid1,eps-r:4.4,tan-d:0.02 or Metal=Solid2,conductor";
inline constexpr const char* port_example = "Feed=Edge5 or Gap=Face3,Face4";
inline constexpr const char* wire_example = "Mast=Edge5,Edge6,radius:0.5mm";

/// Throws Error{bad_option} for names and parts that cannot be, values out of range and parts named twice.
void check_named(const Options& options);

}  // namespace paver
