// Tests examples/backup.cpp as a user runs it: over a serial port, here a pseudo-terminal.

#include "run_program.hpp"
#include "task_test.hpp"

namespace sbgc::test {
namespace {

class BackupExample : public TaskTest {
 protected:
  std::string file(const char* name) const { return (folder_.path() / name).string(); }

  ProgramResult backup(const std::string& arguments) const {
    return run_program(std::string(SBGC_EXAMPLE_BACKUP) + " " + port_ + " " + arguments);
  }

 private:
  std::string port_ = board.serve_terminal();
  TemporaryFolder folder_;
};

TEST_F(BackupExample, SavesComparesAndRestores) {
  const auto original = board.all_settings<msg::ReadParams3>();
  ProgramResult run = backup("save " + file("a.json"));
  ASSERT_EQ(run.status, 0) << run.output;
  EXPECT_THAT(run.output,
              HasSubstr("saved the parameters of 18 messages of a board 3.0 with firmware 2.59"));
  EXPECT_NE(backup("save " + file("a.json")).status, 0) << "it would overwrite the first one";

  board.edit<msg::ReadParams3>(2, [](msg::ReadParams3& params) { params.gyro_trust = 1; });
  run = backup("diff " + file("a.json"));
  ASSERT_EQ(run.status, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("ReadParams3 of profile 3:\n  gyro_trust: "));

  run = backup("restore " + file("a.json") + " " + file("before.json") + " --yes");
  ASSERT_EQ(run.status, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("ReadParams3 of profile 3: written"));
  EXPECT_TRUE(std::filesystem::exists(file("before.json")));
  EXPECT_EQ(board.all_settings<msg::ReadParams3>(), original);

  run = backup("diff " + file("a.json"));
  EXPECT_THAT(run.output, HasSubstr("no differences"));
}

TEST_F(BackupExample, RestoresNothingUnlessThatIsAgreed) {
  ASSERT_EQ(backup("save " + file("a.json")).status, 0);
  board.edit<msg::ReadParams3>(2, [](msg::ReadParams3& params) { params.gyro_trust = 1; });
  const auto edited = board.all_settings<msg::ReadParams3>();
  std::ofstream(file("no")) << "no\n";
  for (const std::string& input : {file("no"), std::string("/dev/null")}) {
    const ProgramResult run =
        backup("restore " + file("a.json") + " " + file("before.json") + " <" + input);
    EXPECT_EQ(run.status, 1) << run.output;
    EXPECT_THAT(run.output, HasSubstr("Type yes"));
    EXPECT_FALSE(std::filesystem::exists(file("before.json")));
    EXPECT_EQ(board.all_settings<msg::ReadParams3>(), edited);
  }
}

}  // namespace
}  // namespace sbgc::test
