#pragma once
#include <filesystem>
#include <string>
#include <vector>

// Where data are. Shipped with Loosefit: materials/, scorecards/. Fetched and baked once: body.lfb.
namespace loosefit {

/// Looks here before anywhere else: what $LOOSEFIT_DATA is for programs, for those who call the
/// library. A folder that holds body.lfb, materials/, scorecards/ or some of them; empty takes it
/// back. For the whole process; call it before the first body or material is read.
void use_data_folder(const std::filesystem::path& folder);

/// `folder` of an installation (its share/loosefit is looked in): a program tells where it was
/// installed, so that the whole of it can be moved. As use_data_folder, for the whole process.
void use_installation(const std::filesystem::path& folder);

/// $XDG_DATA_HOME/loosefit, or ~/.local/share/loosefit; empty when neither is set.
std::filesystem::path user_data_folder();
/// Where `loosefit setup` puts the body for everyone.
inline constexpr char kSystemDataFolder[] = "/var/lib/loosefit";

/// Every folder that is looked in, in this order: use_data_folder; $LOOSEFIT_DATA;
/// user_data_folder(); share/loosefit of the installation, as told or as configured;
/// kSystemDataFolder; var/body/ and data/ of the source tree.
std::vector<std::filesystem::path> data_folders();

/// Folder of the shipped data: $LOOSEFIT_SHARE if set, else the first of data_folders() that holds
/// materials/, else the last of them.
std::filesystem::path data_directory();

/// Where the baked body lives: $LOOSEFIT_DATA if it names a file, else body.lfb in the first of
/// data_folders() that holds it. A folder that was named (use_data_folder, $LOOSEFIT_DATA) and
/// holds no data at all is a mistake: the path in it, which does not exist, is returned, as it is
/// of the first folder when none holds a body.
std::string default_body_data_path();

/// "looked in A, B, C", for whoever finds something missing.
std::string looked_in();

}  // namespace loosefit
