#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace bimodal::runner {

/// Where the socket of a session may be that writes to `data`, in the order in which both sides
/// try: beside the file ("words414.sqlite.monitor" for the suffix ".monitor"), and, where that path
/// is too long for a socket or the disk has none, in $XDG_RUNTIME_DIR and in /tmp, under a name
/// made of the user's number and a digest of the file's absolute path. Symbolic links to the file
/// or its folders are followed. Only paths that fit into a socket's address.
[[nodiscard]] std::vector<std::filesystem::path> socket_places(const std::filesystem::path& data,
                                                               std::string_view suffix);

}  // namespace bimodal::runner
