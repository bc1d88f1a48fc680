
#include <fmt/format.h>
#include <linux/capability.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <sbgc/client/backup.hpp>
#include <sbgc/io/internal/atomic_file.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/meta/parameters.hpp>
#include <sbgc/meta/system.hpp>

#include "task_test.hpp"

namespace sbgc::test {
namespace {

namespace fs = std::filesystem;

class BackupTest : public TaskTest {
 protected:
  Backup make() {
    Result<Backup> backup = client().make_backup();
    EXPECT_TRUE(backup) << backup.error().message;
    return backup ? *backup : Backup{};
  }
  fs::path file(const char* name) const { return folder_.path() / name; }
  std::vector<std::string> files() const {
    std::vector<std::string> result;
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      result.push_back(entry.path().filename().string());
    }
    std::sort(result.begin(), result.end());
    return result;
  }
  /// Restores a backup, after the present state has been saved.
  WriteReport restore(const Backup& backup, const char* saved) {
    return client().restore(backup, {.save_current = save_to(file(saved))});
  }
  static std::string content(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }
  /// Returns the error of parse_backup() after `change(json)` has modified a valid backup.
  template <class Change>
  ClientError wrong(Change&& change) {
    Json document = Json::parse(to_json_text(make()));
    change(document);
    const Result<Backup> backup = parse_backup(document.dump());
    if (backup) {
      ADD_FAILURE() << "it is taken";
      return {};
    }
    return backup.error();
  }

  /// The bodies of all settings.
  using Settings = std::vector<std::vector<std::uint8_t>>;
  Settings settings() {
    Settings result;
    BackedUp::for_each([&]<class M>(Type<M>) {
      for (const M& one : board.all_settings<M>()) result.push_back(packet(one).body);
    });
    return result;
  }
  /// Makes all settings different from each other and from the factory settings.
  void mark() {
    for (std::uint8_t profile = 0; profile < 5; ++profile) {
      board.edit<msg::ReadParams3>(profile, [&](msg::ReadParams3& params) {
        params.gyro_trust = static_cast<std::uint8_t>(10 + profile);
      });
      board.edit<msg::ReadParamsExt>(
          profile, [&](msg::ReadParamsExt& params) { params.reserved[0] = profile; });
      board.edit<msg::ReadParamsExt2>(profile, [&](msg::ReadParamsExt2& params) {
        params.auto_pid_momentum = static_cast<std::uint8_t>(200 + profile);
      });
    }
    board.edit<msg::ReadProfileNames>(0, [](auto& names) {
      ASSERT_TRUE(names.profile_name[1].assign(std::string_view("Marked")));
    });
    board.edit<msg::ReadAdjVarsCfg>(0, [](auto& variables) { variables.reserved[0] = 77; });
    board.edit<msg::ReadExternalData>(0, [](auto& external) {
      for (std::size_t i = 0; i < external.data.size(); ++i) {
        external.data[i] = static_cast<std::uint8_t>(i * 3 + 1);
      }
    });
  }
  /// Changes one setting.
  void change() {
    board.edit<msg::ReadParams3>(0, [](msg::ReadParams3& params) { params.gyro_trust = 1; });
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(BackupTest, OnlyARegularFileIsReplaced) {
  ASSERT_EQ(::mkfifo(file("pipe").c_str(), 0600), 0);
  ASSERT_EQ(::symlink(file("pipe").c_str(), file("link").c_str()), 0);
  for (const char* const name : {"pipe", "link"}) {
    const Result<void> saved = save_backup(make(), file(name), Existing::replace);
    ASSERT_FALSE(saved) << name;
    EXPECT_THAT(saved.error().message, HasSubstr("pipe is not a regular file"));
  }
  EXPECT_TRUE(std::filesystem::is_fifo(file("pipe")));
  EXPECT_EQ(load_backup(file("pipe")).error().code, ErrorCode::bad_file) << "nobody waits for it";
  const Result<void> saved = save_backup(make(), file("no/where.json"), Existing::replace);
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().message, HasSubstr("where.json: "));
}

TEST_F(BackupTest, NothingIsLostOnTheWayThroughAFile) {
  const Backup backup = make();
  ASSERT_TRUE(save_backup(backup, file("a.json")));
  const auto again = checked(load_backup(file("a.json")));
  EXPECT_EQ(again->parameters, backup.parameters);
  EXPECT_EQ(again->board.info, client().identity().info);
  EXPECT_EQ(again->board.details, board.read<msg::BoardInfo3>(msg::BoardInfo3Request{}));
  EXPECT_EQ(again->created, backup.created);
  EXPECT_EQ(again->created.size(), std::string("2024-05-01T12:00:00Z").size());
  EXPECT_EQ(to_json_text(*again), to_json_text(backup));
  EXPECT_THAT(files(), ElementsAre("a.json"));
}

TEST_F(BackupTest, AFileTellsWhichBoardItIsOf) {
  const Json document = Json::parse(to_json_text(make()));
  EXPECT_EQ(document["board"]["model"], "3.0");
  EXPECT_THAT(document["board"]["firmware"].get<std::string>(), HasSubstr("2.59"));
  EXPECT_EQ(document["board"]["info"]["fields"]["firmware_ver"], 2590);
  EXPECT_EQ(document["board"]["details"]["fields"]["mcu_id"],
            detail::to_hex(board.options().mcu_id));
  EXPECT_EQ(document["board"].value("serial_number", ""), client().identity().serial_number());
  EXPECT_EQ(document["settings"].size(), 18U);
  Backup bare = make();
  bare.board.details.reset();
  EXPECT_THAT(Json::parse(to_json_text(bare))["board"], SizeIs(3)) << "model, firmware and info";
}

TEST_F(BackupTest, AnExistingFileIsKept) {
  std::ofstream(file("a.json")) << "precious";
  EXPECT_THAT(save_backup(make(), file("a.json")), fails(ErrorCode::invalid));
  EXPECT_EQ(content(file("a.json")), "precious");
  EXPECT_THAT(files(), ElementsAre("a.json"));
}

TEST_F(BackupTest, WhatReplacesAFileHasItsMode) {
  for (const auto mode : {fs::perms::owner_read, fs::perms::owner_all | fs::perms::group_write}) {
    std::ofstream(file("a.json")) << "old";
    fs::permissions(file("a.json"), mode);
    ASSERT_TRUE(save_backup(make(), file("a.json"), Existing::replace));
    EXPECT_EQ(fs::status(file("a.json")).permissions(), mode);
    EXPECT_TRUE(load_backup(file("a.json"))) << "it is replaced as a whole";
    EXPECT_THAT(files(), ElementsAre("a.json"));
    fs::remove(file("a.json"));
  }
}

TEST_F(BackupTest, ASymbolicLinkStaysOne) {
  fs::create_directory(file("folder"));
  fs::create_symlink("folder/b.json", file("a.json"));
  ASSERT_TRUE(save_backup(make(), file("a.json"))) << "there is no file yet";
  EXPECT_TRUE(load_backup(file("folder/b.json")));
  EXPECT_FALSE(save_backup(make(), file("a.json")));
  std::ofstream(file("folder/b.json")) << "old";
  ASSERT_TRUE(save_backup(make(), file("a.json"), Existing::replace));
  EXPECT_TRUE(load_backup(file("folder/b.json")));
  EXPECT_TRUE(fs::is_symlink(file("a.json")));
  EXPECT_THAT(files(), ElementsAre("a.json", "folder"));
}

TEST_F(BackupTest, WhatCannotBeWrittenLeavesNothingBehind) {
  EXPECT_THAT(save_backup(make(), file("missing/a.json")), fails(ErrorCode::not_found));
  fs::create_directory(file("folder"));
  EXPECT_FALSE(save_backup(make(), file("folder"), Existing::replace));
  EXPECT_THAT(files(), ElementsAre("folder"));
}

TEST_F(BackupTest, WhatAKilledProcessLeftBehindIsNoHindrance) {
  for (int i = 0; i < 100; ++i) {  // names that this process would choose
    std::ofstream(file(
        ("a.json." + std::to_string(::getpid()) + "-" + std::to_string(i) + ".sbgc-tmp").c_str()));
  }
  ASSERT_TRUE(save_backup(make(), file("a.json")));
  EXPECT_TRUE(load_backup(file("a.json")));
  EXPECT_THAT(files(), ElementsAre("a.json")) << "no process has a lock on the others";
}

TEST_F(BackupTest, WhatOnlyLooksLikeALeftoverIsKept) {
  ASSERT_EQ(::mkfifo(file("pipe.1-1.sbgc-tmp").c_str(), 0600), 0);  // to be opened without waiting
  fs::create_directory(file("folder.1-1.sbgc-tmp"));
  fs::create_symlink("none", file("link.1-1.sbgc-tmp"));
  ASSERT_TRUE(save_backup(make(), file("a.json")));
  EXPECT_THAT(files(), UnorderedElementsAre("a.json", "folder.1-1.sbgc-tmp", "link.1-1.sbgc-tmp",
                                            "pipe.1-1.sbgc-tmp"));
}

TEST_F(BackupTest, LinksThatFormACycleStay) {
  fs::create_symlink("b.json", file("a.json"));
  fs::create_symlink("a.json", file("b.json"));
  EXPECT_FALSE(save_backup(make(), file("a.json"), Existing::replace));
  EXPECT_TRUE(fs::is_symlink(file("a.json")));
  EXPECT_TRUE(fs::is_symlink(file("b.json")));
}

/// While it lives, this thread is bound by the modes of files even if it is of root.
class BoundByModes {
 public:
  BoundByModes() {
    EXPECT_EQ(::syscall(SYS_capget, &header_, before_.data()), 0);
    auto none = before_;
    for (auto& part : none) part.effective = 0;
    EXPECT_EQ(::syscall(SYS_capset, &header_, none.data()), 0);
  }
  BoundByModes(const BoundByModes&) = delete;
  BoundByModes& operator=(const BoundByModes&) = delete;
  ~BoundByModes() { EXPECT_EQ(::syscall(SYS_capset, &header_, before_.data()), 0); }

 private:
  __user_cap_header_struct header_{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> before_{};
};

TEST_F(BackupTest, AFolderThatCannotBeReadIsNotFlushed) {
  const fs::path folder = file("closed");
  const Backup backup = make();
  ASSERT_EQ(::mkdir(folder.c_str(), 0300), 0);
  const Result<void> saved = [&] {
    const BoundByModes bound;
    return save_backup(backup, folder / "a.json");
  }();
  ASSERT_EQ(::chmod(folder.c_str(), 0700), 0);
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().message, HasSubstr("cannot flush to disk: "));
  EXPECT_THAT(saved.error().message, HasSubstr("Permission denied"));
  EXPECT_TRUE(load_backup(folder / "a.json")) << "it is written all the same";
}

TEST_F(BackupTest, MissingLargeAndForeignFilesAreNamed) {
  std::ofstream(file("five")) << "12345";
  EXPECT_FALSE(detail::read_whole_file(file("five"), 4));
  EXPECT_EQ(*checked(detail::read_whole_file(file("five"), 5)), "12345");
  EXPECT_EQ(load_backup(file("none.json")).error().code, ErrorCode::not_found);
  const std::pair<std::string, const char*> contents[] = {
      {"hello", "text"},
      {"", "an empty file"},
      {" \n<saved-configuration/>", "XML of the vendor's program"},
      {"<?xml version='1.0'?>\n<saved-configuration/>", "XML of the vendor's program"},
      {"<svg/>", "XML"},
      {"<html><saved-configuration/>", "an HTML page"},
      {"PK\x03\x04", "a ZIP archive"},
      {std::string("\x1F\x8B\0", 3), "gzip data"},
      {std::string("a\0", 2), "binary data"},
      {"[]", "other JSON"},
  };
  for (const auto& [content, kind] : contents) {
    std::ofstream(file("other")) << content;
    EXPECT_THAT(load_backup(file("other")),
                fails(ErrorCode::bad_file, Eq(fmt::format("{}: this is {}, not an sbgc backup",
                                                          file("other").string(), kind))));
  }
  EXPECT_EQ(parse_backup("{}").error().message, "this is other JSON, not an sbgc backup");
  EXPECT_THAT(parse_backup("{\"format\": }").error().message,
              HasSubstr("this is not JSON (line 1"));
}

TEST_F(BackupTest, EveryBeginningOfAFileIsRefused) {
  const std::string text = to_json_text(make());
  for (std::size_t size = 0; size + 2 < text.size(); size += 131) {
    EXPECT_FALSE(parse_backup(text.substr(0, size))) << size;
  }
}

TEST_F(BackupTest, AFileThatIsMadeToDoHarmIsRefused) {
  const std::string deep(200'000, '[');
  std::ofstream(file("deep")) << R"({"format":"sbgc-backup","version":)" << deep
                              << std::string(deep.size(), ']') << "}";
  EXPECT_THAT(load_backup(file("deep")),
              fails(ErrorCode::bad_file, "nested deeper than 64 levels (line 1, column "));
  std::string text = to_json_text(make());
  text.insert(1, R"("created":"",)");
  EXPECT_THAT(parse_backup(text).error().message, HasSubstr("the key 'created' occurs twice"));
}

/// A change of a value, or its removal if there is no value, and the message of the error.
struct WrongValue {
  const char* at;
  const char* value;
  const char* message;
};

TEST_F(BackupTest, EverythingInAFileIsChecked) {
  const Json good = Json::parse(to_json_text(make()));
  for (const auto& [at, value, message] : std::initializer_list<WrongValue>{
           {"/format", R"("sbgc-other")",
            "this is JSON of the format \"sbgc-other\", not an sbgc backup"},
           {"/version", R"("1")", "version"},
           {"/board", nullptr, "board: it is missing"},
           {"/board/info/body", R"("1e")", "board.info.body"},
           {"/board/details/message", R"("BoardInfo")",
            "board.details.message: expected BoardInfo3"},
           {"/settings", "5", "settings"},
           {"/settings/3/copy", "7", "settings[3]"},
           {"/settings/3/copy", "-1", "settings[3].copy"},
           {"/settings/2/body", R"("xy")", "settings[2].body"},
           {"/settings/0/message", R"("Beep")", "Beep"},
           {"/settings/2/fields/axes/yaw/p", "255", "settings[2].fields.axes.yaw.p"},
           {"/settings/2/fields/axes/yaw", "5", "settings[2].fields.axes.yaw"},
           {"/board/model", R"("3.1")", "board.model: differs from the body, which says \""},
           {"/board/firmware", R"("3.1")", "board.firmware: differs from the body, which says \""},
           {"/board/serial_number", R"("3.1")",
            "board.serial_number: differs from the body, which says \""},
           {"/contents", nullptr, "contents: it is missing"},
           {"/checksum", nullptr, "checksum: it is missing"},
           {"/contents/0", nullptr, "the identity of the board, or 'contents', was edited"},
           {"/contents", "5", "contents: expected a list"},
           {"/contents/1", "5", "contents[1].message: it is missing"},
           {"/contents/1/copies", "5", "contents[1].copies: expected a list"},
           {"/contents/0/copies/1", "256",
            "contents[0].copies[1]: expected a number from 0 to 255"},
           {"/contents/0/copies/1", "255", "or 'contents', was edited"}}) {
    Json change{{"op", value == nullptr ? "remove" : "replace"}, {"path", at}};
    if (value != nullptr) change["value"] = Json::parse(value);
    EXPECT_THAT(parse_backup(good.patch(Json::array({change})).dump()),
                fails(ErrorCode::bad_file, message));
  }
  EXPECT_EQ(wrong([](Json& json) { json["version"] = 2; }).code, ErrorCode::incompatible);
  EXPECT_THAT(wrong([](Json& json) { json["settings"][1] = json["settings"][0]; }).message,
              HasSubstr("duplicate"));
}

TEST_F(BackupTest, ABodyHasAtMostTheBytesOfAFrame) {
  const auto message = [&](std::size_t size) {
    return wrong([&](Json& json) {
             json["board"]["info"]["body"] = detail::to_hex(std::vector<std::uint8_t>(size));
           })
        .message;
  };
  EXPECT_THAT(message(max_body_size + 1), HasSubstr("at most 255 bytes"));
  EXPECT_THAT(message(max_body_size), Not(HasSubstr("at most 255 bytes")));
}

TEST_F(BackupTest, FieldsThatAnotherVersionCallsByAnotherNameAreTaken) {
  Json document = Json::parse(to_json_text(make()));
  document["settings"][0]["fields"]["new_name"] = document["settings"][0]["fields"]["axes"];
  document["settings"][0]["fields"].erase("axes");
  const Result<Backup> damaged = parse_backup(document.dump());
  ASSERT_FALSE(damaged) << "it was written with other names";
  EXPECT_EQ(damaged.error().message, "settings[0].fields: a name was edited");
  document["settings"][0].erase("names");  // as in files of earlier versions
  EXPECT_TRUE(parse_backup(document.dump()));
}

TEST_F(BackupTest, EveryDamagedNameIsRefused) {
  const std::string file = to_json_text(make());
  std::size_t names = 0;
  for (std::size_t end = 0; (end = file.find("\":", end + 1)) != std::string::npos;) {
    std::string damaged = file;
    damaged[end - 1] ^= 1;
    // All kinds of places, but not each of a file with thousands of names.
    if (++names % 97 != 0 && names > 60) continue;
    EXPECT_FALSE(parse_backup(damaged)) << file.substr(end - 20, 22);
  }
  EXPECT_GT(names, 1000U);
}

// Made when most bytes of ReadParamsExt2 and BoardInfo3 had no names.
TEST_F(BackupTest, AFileFromBeforeReservedBytesHadNamesIsRestored) {
  mark();
  const auto backup = checked(load_backup(SBGC_TEST_DATA "/backup_of_rev_0.15.json"));
  ASSERT_THAT(backup->parameters.all(), SizeIs(6));
  EXPECT_THAT(backup->missing, IsEmpty()) << "it does not list what it holds";
  EXPECT_THAT(left_alone(client().identity(), *backup), SizeIs(make().parameters.all().size() - 6));
  const WriteReport report = restore(*backup, "present.json");
  ASSERT_TRUE(report) << to_text(report);
  const ParameterSet now = make().parameters;
  for (const Parameters& block : backup->parameters.all()) {
    ASSERT_NE(now.find(block.id), nullptr);
    EXPECT_EQ(now.find(block.id)->body, block.body) << block.id.message;
  }
}

TEST_F(BackupTest, RestoringBringsEverythingBack) {
  mark();
  // Later firmware sends more than is documented.
  board.edit<msg::ReadParams3>(3, [](auto& params) { params.tail.push_back(42); });
  const Settings original = settings();
  const Backup backup = make();
  for (std::uint8_t profile = 0; profile < 5; ++profile) {
    board.edit<msg::ReadParams3>(profile, [](auto& params) { ++params.gyro_trust; });
  }
  board.edit<msg::ReadParamsExt2>(2, [](auto& params) { params.auto_pid_momentum = 0; });
  board.edit<msg::ReadExternalData>(0, [](auto& external) { external.data[127] = 0; });
  board.edit<msg::ReadProfileNames>(
      0, [](auto& names) { ASSERT_TRUE(names.profile_name[1].assign(std::string_view("Other"))); });
  ASSERT_NE(settings(), original);

  const Result<Backup> changed = client().make_backup();
  const WriteReport report = restore(backup, "present.json");
  ASSERT_TRUE(report) << to_text(report);
  EXPECT_EQ(settings(), original);
  const Result<Backup> saved = load_backup(file("present.json"));
  ASSERT_TRUE(saved);
  EXPECT_EQ(saved->parameters, changed->parameters);
}

TEST_F(BackupTest, AnErasedBoardGetsBackEveryBitOfItsSettings) {
  mark();
  const Settings original = settings();
  const Backup backup = make();
  board.write(msg::UseDefaults{.profile_id = msg::UseDefaults::erase_eeprom});
  ASSERT_THAT(board.memory().eeprom, Each(0xFF));

  WriteReport report = restore(backup, "present.json");
  ASSERT_TRUE(report) << to_text(report);
  EXPECT_EQ(settings(), original);
  EXPECT_EQ(make().parameters, backup.parameters);
  // The restored settings are not only in use but stored: another board with the same EEPROM has
  // them.
  connect();
  disconnect();
  board.become(board.options());
  EXPECT_EQ(settings(), original);
  report = restore(backup, "again.json");
  ASSERT_TRUE(report);
  EXPECT_EQ(count<msg::WriteParams3>(), 0U);
}

TEST_F(BackupTest, AnotherModelOrFirmwareIsRefusedUnlessTold) {
  const Backup backup = make();
  change();
  become(msg::BoardVersion(31));
  WriteReport report = restore(backup, "a.json");
  ASSERT_THAT(report, fails(ErrorCode::incompatible, "3.1"));
  EXPECT_THAT(files(), IsEmpty());

  become(msg::FirmwareVersion(2604));
  report = client().restore(backup,
                            {.save_current = save_to(file("a.json")), .allow_other_model = true});
  ASSERT_FALSE(report);
  EXPECT_THAT(report.outcome.error().message, HasSubstr("2.60b4"));
  EXPECT_EQ(board.settings<msg::ReadParams3>(0).gyro_trust, 1);
  EXPECT_THAT(mismatches(client().identity(), backup.board), SizeIs(2));

  report = client().restore(backup, {.save_current = save_to(file("a.json")),
                                     .allow_other_model = true,
                                     .allow_other_firmware = true});
  EXPECT_TRUE(report) << to_text(report);
  EXPECT_NE(board.settings<msg::ReadParams3>(0).gyro_trust, 1);
}

TEST_F(BackupTest, AParameterSetThatWasRemovedFromTheFileIsNamed) {
  Json document = Json::parse(to_json_text(make()));
  change();
  const Json removed = document["settings"][4];  // not the one that change() changes
  document["settings"].erase(4);
  const auto backup = checked(parse_backup(document.dump()));
  const ParametersId id{removed["message"], removed["copy"]};
  EXPECT_THAT(backup->missing, ElementsAre(id));
  EXPECT_THAT(left_alone(client().identity(), *backup), ElementsAre(id));
  EXPECT_EQ(parse_backup(to_json_text(*backup))->missing, backup->missing) << "it stays known";

  for (const bool dry_run : {true, false}) {
    EXPECT_THAT(
        client().restore(*backup, {.save_current = save_to(file("a.json")), .dry_run = dry_run}),
        fails(ErrorCode::bad_file, HasSubstr("the backup lacks what it lists: " + to_text(id))));
  }
  EXPECT_THAT(files(), IsEmpty());
  EXPECT_EQ(board.settings<msg::ReadParams3>(0).gyro_trust, 1);
  const WriteReport report =
      client().restore(*backup, {.save_current = save_to(file("a.json")), .allow_partial = true});
  EXPECT_TRUE(report) << to_text(report);
  EXPECT_NE(board.settings<msg::ReadParams3>(0).gyro_trust, 1);
}

TEST_F(BackupTest, ABackupWithoutParametersRestoresNothing) {
  Json document = Json::parse(to_json_text(make()));
  document["settings"] = Json::array();
  const auto refused = [&] {
    const Result<Backup> backup = parse_backup(document.dump());
    EXPECT_TRUE(backup) << backup.error().message;
    const WriteReport report = client().restore(*backup, {.dry_run = true, .allow_partial = true});
    EXPECT_FALSE(report);
    return report ? "" : report.outcome.error().message;
  };
  EXPECT_EQ(refused(), "the backup holds no parameters");
  document.erase("contents");
  document.erase("checksum");
  EXPECT_EQ(refused(), "the backup holds no parameters") << "also in a file of 0.1.0";
}

/// Replaces a body, and the fields that it decodes to.
template <class M, class Change>
void edit(Json& json, Change&& change) {
  M message{};
  const auto body = detail::from_hex(json["body"].get<std::string>());
  ASSERT_TRUE(body && decode(std::span(*body), message));
  change(message);
  json["body"] = detail::to_hex(packet(message).body);
  json["fields"] = to_dom(message);
}

TEST_F(BackupTest, AnEditedIdentityIsNoticed) {
  const auto edited = [](const ClientError& error) {
    EXPECT_EQ(error.code, ErrorCode::bad_file);
    EXPECT_THAT(error.message, HasSubstr("the identity of the board, or 'contents', was edited"));
  };
  // Consistently in all places.
  edited(wrong([](Json& json) {
    edit<msg::BoardInfo>(json["board"]["info"],
                         [](auto& info) { info.board_ver = msg::BoardVersion(31); });
    json["board"]["model"] = "3.1";
  }));
  edited(wrong([](Json& json) {
    edit<msg::BoardInfo>(json["board"]["info"],
                         [](auto& info) { info.firmware_ver = msg::FirmwareVersion(2604); });
    json["board"]["firmware"] = "2.60b4";
  }));
  edited(wrong([](Json& json) {
    edit<msg::BoardInfo3>(json["board"]["details"],
                          [](auto& details) { details.device_id[0] ^= 1; });
    json["board"].erase("serial_number");
  }));
  edited(wrong([](Json& json) {
    json["board"].erase("details");
    json["board"].erase("serial_number");
  }));
}

TEST_F(BackupTest, ValuesMayBeEdited) {
  Json document = Json::parse(to_json_text(make()));
  document["created"] = "today";
  edit<msg::ReadParams3>(document["settings"][0], [](auto& params) { params.gyro_trust = 77; });
  const auto backup = checked(parse_backup(document.dump()));
  EXPECT_THAT(backup->missing, IsEmpty());
  ASSERT_TRUE(restore(*backup, "a.json"));
  EXPECT_EQ(board.settings<msg::ReadParams3>(0).gyro_trust, 77);
}

TEST_F(BackupTest, AParameterSetThatTheFileDoesNotListIsRefused) {
  Backup some;
  some.board = client().identity();
  const Backup all = make();
  ASSERT_TRUE(some.parameters.put(all.parameters.all().front()));
  Json document = Json::parse(to_json_text(some));
  document["settings"] = Json::parse(to_json_text(all))["settings"];
  const Result<Backup> backup = parse_backup(document.dump());
  ASSERT_FALSE(backup);
  EXPECT_EQ(backup.error().message,
            "contents: " + to_text(all.parameters.all()[1].id) + " is not listed");
}

TEST_F(BackupTest, ADryRunNeedsNoFileAndWritesNothing) {
  const Backup backup = make();
  change();
  const Settings before = settings();
  const WriteReport report = client().restore(backup, {.dry_run = true});
  EXPECT_TRUE(report);
  EXPECT_EQ(report.parameters.front().wanted.size(), 1U);
  EXPECT_EQ(settings(), before);
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(BackupTest, WithoutABackupOfThePresentStateNothingIsRestored) {
  const Backup backup = make();
  change();
  EXPECT_EQ(client().restore(backup, {}).outcome.error().code, ErrorCode::invalid);
  std::ofstream(file("a.json")) << "precious";
  EXPECT_FALSE(restore(backup, "a.json"));
  EXPECT_EQ(content(file("a.json")), "precious");
  EXPECT_EQ(count<msg::WriteParams3>(), 0U);
  EXPECT_EQ(board.settings<msg::ReadParams3>(0).gyro_trust, 1);
}

}  // namespace
}  // namespace sbgc::test
