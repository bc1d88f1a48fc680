
#include <sbgc/client/profiles.hpp>

#include "task_test.hpp"

namespace sbgc::test {
namespace {

class ProfilesTest : public TaskTest {
 protected:
  ProfilesTest() {
    board.store(msg::ReadProfileNames{});
    set(0, "Handheld");
  }
  void set(std::size_t profile, std::string_view name) {
    board.edit<msg::ReadProfileNames>(
        0, [&](auto& names) { ASSERT_TRUE(names.profile_name[profile].assign(name)); });
  }
  msg::ReadProfileNames names() { return board.settings<msg::ReadProfileNames>(); }
};

TEST_F(ProfilesTest, TellsTheActiveProfile) {
  EXPECT_EQ(*client().active_profile(), 0U);
  board.write(msg::ExecuteMenu{msg::MenuCommand::profile5});
  const auto active = checked(client().active_profile());
  EXPECT_EQ(*active, 4U);
}

TEST_F(ProfilesTest, AnActiveProfileThatDoesNotExistIsRefused) {
  board.tamper([](Packets& answers) {
    for (Packet& one : answers) {
      if (is<msg::ReadParams3>(one)) one.body.back() = profile_count;
    }
  });
  EXPECT_EQ(client().active_profile().error().code, ErrorCode::bad_response);
}

TEST_F(ProfilesTest, NamesAreReadWithoutTheirPadding) {
  set(2, "Höhe ½");
  const auto read = checked(client().profile_names());
  EXPECT_THAT(*read, ElementsAre("Handheld", "", "Höhe ½", "", ""));
}

TEST_F(ProfilesTest, ANameIsWrittenAndTheOthersStayToTheLastByte) {
  board.edit<msg::ReadProfileNames>(0, [](auto& names) {  // invalid UTF-8 and a NUL
    names.profile_name[1].bytes = {'a', '\0', '\xFF', 'b'};
  });
  const auto before = names();
  ASSERT_TRUE(client().rename_profile(3, "Follow €"));
  EXPECT_EQ(client().profile_names()->at(3), "Follow €");
  EXPECT_EQ(names().profile_name[1], before.profile_name[1]);
  EXPECT_EQ(names().profile_name[0], before.profile_name[0]);
}

TEST_F(ProfilesTest, AllNamesAreWritten) {
  const ProfileNames wanted{"1", "2", "", "4", std::string(48, 'x')};
  ASSERT_TRUE(client().rename_profiles(wanted));
  EXPECT_EQ(*client().profile_names(), wanted);
}

TEST_F(ProfilesTest, ANameThatDoesNotFitIsRefusedAndNeverCut) {
  const std::string euros = [] {
    std::string text;
    for (int i = 0; i < 17; ++i) text += "€";  // 3 bytes each: 51
    return text;
  }();
  const auto before = names();
  const auto error = client().rename_profile(0, euros).error();
  EXPECT_EQ(error.code, ErrorCode::invalid);
  EXPECT_THAT(error.message, HasSubstr("at most 48 bytes, this one has 51"));
  EXPECT_FALSE(client().rename_profile(0, std::string(49, 'x')));
  EXPECT_TRUE(check_profile_name(euros.substr(0, 48)));
  EXPECT_EQ(names(), before);
  EXPECT_EQ(board.log().size(), 0U);
}

TEST_F(ProfilesTest, ANameThatIsNoUtf8IsRefused) {
  EXPECT_THAT(check_profile_name("ab\xC3").error().message, HasSubstr("byte 3"));
  EXPECT_FALSE(check_profile_name("\xED\xA0\x80"));  // half of a surrogate pair
  EXPECT_FALSE(check_profile_name("\xC0\x80"));      // overlong
  EXPECT_FALSE(check_profile_name(std::string_view("a\0b", 3)));
  EXPECT_FALSE(client().rename_profiles({"", "", "\xFF", "", ""}));
  EXPECT_THAT(client().rename_profiles({"", "", "\xFF", "", ""}).error().message,
              HasSubstr("profile 3"));
  EXPECT_EQ(board.log().size(), 0U);
}

TEST_F(ProfilesTest, ThereAreFiveProfiles) {
  EXPECT_EQ(client().rename_profile(5, "x").error().code, ErrorCode::invalid);
}

TEST_F(ProfilesTest, NamesThatTheBoardDoesNotKeepAreNoticed) {
  board.after([&](const Packet& request) {
    if (is<msg::WriteProfileNames>(request)) board.store(msg::ReadProfileNames{});
  });
  const auto error = client().rename_profile(0, "x").error();
  EXPECT_EQ(error.code, ErrorCode::mismatch);
  EXPECT_THAT(error.message, HasSubstr("the board confirmed ReadProfileNames, but it reads back"));
}

TEST_F(ProfilesTest, ALostRenamingIsRepeatedAndNeverCalledConfirmed) {
  int lost = 0;
  board.on_lost(
      [&](const Packet& request) { return is<msg::WriteProfileNames>(request) && lost++ == 0; });
  ASSERT_TRUE(client().rename_profile(0, "once"));
  EXPECT_EQ(client().profile_names()->at(0), "once");
  board.on_lost(is<msg::WriteProfileNames>);
  const auto error = client().rename_profile(0, "never").error();
  EXPECT_EQ(error.message,
            "the board did not confirm ReadProfileNames, and it reads back as before");
}

}  // namespace
}  // namespace sbgc::test
