// Files that are dropped on a window as a file manager does it: by XDND 5 (freedesktop.org, "Drag-and-Drop
// Protocol for the X Window System").
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace unghost {

/// As file URIs, a line each (RFC 2483). All but letters, digits and "/-._~" is percent-encoded.
std::string uri_list(const std::vector<std::filesystem::path>& files);

/// Waits until the window has taken them. Throws std::runtime_error where it does not.
void drop_files(const std::string& display, unsigned long window,
                const std::vector<std::filesystem::path>& files);

} // namespace unghost
