#include "app/demo/file_watch.h"

#include <sys/stat.h>

namespace unghost {
namespace {

constexpr std::chrono::milliseconds between_looks(500);

} // namespace

FileWatch::Stamp FileWatch::stamp_of(const std::filesystem::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) return {};
  return {.device = status.st_dev,
          .inode = status.st_ino,
          .bytes = uint64_t(status.st_size),
          .written_s = status.st_mtim.tv_sec,
          .written_ns = status.st_mtim.tv_nsec};
}

void FileWatch::add(const std::vector<std::filesystem::path>& files) {
  for (const std::filesystem::path& file : files)
    if (!said_.contains(file)) said_[file] = seen_[file] = stamp_of(file);
}

bool FileWatch::changed(Time now) {
  if (now < next_look_) return false;
  next_look_ = now + between_looks;
  Stamps there;
  for (const auto& [file, unused] : said_) there[file] = stamp_of(file);
  const bool rests = there == seen_;
  seen_ = std::move(there);
  if (!rests || seen_ == said_) return false;
  said_ = seen_;
  return true;
}

} // namespace unghost
