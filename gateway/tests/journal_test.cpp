// The journal of a gateway: its contents survive the death of the process.

#include "gateway/journal.hpp"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace sbgc::tools {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::ThrowsMessage;

/// Uses a folder that is removed after the test.
class JournalTest : public testing::Test {
 protected:
  JournalTest() {
    std::string name = (std::filesystem::temp_directory_path() / "journal.XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp");
    folder_ = name;
  }
  JournalTest(const JournalTest&) = delete;
  JournalTest& operator=(const JournalTest&) = delete;
  ~JournalTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path file() const { return folder_ / "fleet.db"; }

 private:
  std::filesystem::path folder_;
};

/// Runs `changes` in one transaction.
template <class Changes>
auto within(Journal& journal, const Changes& changes) {
  journal.begin();
  const auto result = changes();
  journal.commit();
  return result;
}

JournalCommand a_command(const std::string& key, const std::string& reply = "sbgc/f/reply/a") {
  return {"front", key, "move {}", {reply, "c1"}};
}

constexpr Journal::Time noon{std::chrono::hours(12)};

TEST_F(JournalTest, a_command_is_unfinished_until_its_result_is_kept) {
  Journal journal(file(), {});
  const auto id = within(journal, [&] { return journal.admit(a_command("k"), noon); });
  ASSERT_TRUE(id);
  EXPECT_THAT(journal.unfinished(), SizeIs(1));
  const auto replies = within(journal, [&] { return journal.finish(*id, "{}"); });
  EXPECT_THAT(replies, ElementsAre(ReplyAddress{"sbgc/f/reply/a", "c1"}));
  EXPECT_THAT(journal.unfinished(), IsEmpty());
}

TEST_F(JournalTest, a_result_is_kept_once) {
  Journal journal(file(), {});
  const auto id = within(journal, [&] { return journal.admit(a_command("k"), noon); });
  within(journal, [&] { return journal.finish(*id, "first"); });
  EXPECT_THAT(within(journal, [&] { return journal.finish(*id, "second"); }), IsEmpty());
  EXPECT_EQ(journal.recognize(a_command("k")).result, "first");
}

TEST_F(JournalTest, a_key_is_recognized) {
  Journal journal(file(), {});
  const auto recognize = [&](const JournalCommand& command) {
    return within(journal, [&] { return journal.recognize(command); }).recognition;
  };
  EXPECT_EQ(recognize(a_command("k")), Recognition::unknown);
  const auto id = within(journal, [&] { return journal.admit(a_command("k"), noon); });
  EXPECT_EQ(recognize(a_command("k")), Recognition::running);
  EXPECT_EQ(recognize(a_command("other")), Recognition::unknown);
  JournalCommand of_other_gimbal = a_command("k");
  of_other_gimbal.gimbal = "rear";
  EXPECT_EQ(recognize(of_other_gimbal), Recognition::unknown);
  JournalCommand of_other_task = a_command("k");
  of_other_task.request = "home {}";
  EXPECT_EQ(recognize(of_other_task), Recognition::reused);
  within(journal, [&] { return journal.finish(*id, "{}"); });
  EXPECT_EQ(recognize(a_command("k")), Recognition::finished);
}

TEST_F(JournalTest, a_command_without_a_key_may_be_repeated) {
  Journal journal(file(), {});
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(journal.recognize(a_command("")).recognition, Recognition::unknown);
    EXPECT_TRUE(within(journal, [&] { return journal.admit(a_command(""), noon); }));
  }
  EXPECT_THAT(journal.unfinished(), SizeIs(2));
}

TEST_F(JournalTest, every_address_that_asked_while_it_ran_gets_the_result) {
  Journal journal(file(), {});
  const auto id =
      within(journal, [&] { return journal.admit(a_command("k", "sbgc/f/reply/a"), noon); });
  for (int i = 0; i < 2; ++i) {
    within(journal,
           [&] { return journal.recognize(a_command("k", "sbgc/f/reply/b")).recognition; });
  }
  EXPECT_THAT(within(journal, [&] { return journal.finish(*id, "{}"); }), SizeIs(2));
}

TEST_F(JournalTest, messages_wait_in_their_order) {
  Journal journal(file(), {});
  journal.begin();
  for (const char* const text : {"1", "2", "3"}) journal.put({.topic = "t", .payload = text});
  journal.commit();
  const auto waiting = journal.waiting_after(0, 2);
  ASSERT_THAT(waiting, SizeIs(2));
  EXPECT_EQ(waiting[0].payload + waiting[1].payload, "12");
  EXPECT_EQ(journal.waiting_after(waiting[1].id, 2).at(0).payload, "3");
  journal.begin();
  journal.remove(waiting[0].id);
  journal.commit();
  EXPECT_EQ(journal.waiting(), 2U);
}

TEST_F(JournalTest, bytes_survive) {
  const std::string bytes("\0\xff\x01", 3);
  Journal journal(file(), {});
  journal.begin();
  journal.put({.topic = "t", .payload = "p", .correlation = bytes});
  journal.commit();
  EXPECT_EQ(journal.waiting_after(0, 1).at(0).correlation, bytes);
}

TEST_F(JournalTest, the_oldest_notice_gives_way_and_no_result) {
  Journal journal(file(), {.most_waiting = 3});
  journal.begin();
  journal.put({.kind = WaitingKind::result, .topic = "t", .payload = "result"});
  for (const char* const text : {"1", "2", "3", "4"}) {
    journal.put({.kind = WaitingKind::notice, .topic = "t", .payload = text});
  }
  journal.commit();
  std::string all;
  for (const WaitingMessage& one : journal.waiting_after(0, 9)) all += one.payload + ' ';
  EXPECT_EQ(all, "result 3 4 ");
  EXPECT_EQ(journal.dropped(), 2U);
  EXPECT_EQ(journal.waiting(), 3U);
}

TEST_F(JournalTest, a_notice_without_room_is_dropped) {
  Journal journal(file(), {.most_waiting = 1});
  journal.begin();
  journal.put({.kind = WaitingKind::result, .topic = "t", .payload = "result"});
  journal.put({.kind = WaitingKind::notice, .topic = "t", .payload = "notice"});
  journal.commit();
  EXPECT_EQ(journal.waiting(), 1U);
  EXPECT_EQ(journal.dropped(), 1U);
}

TEST_F(JournalTest, no_command_begins_without_room_for_its_result) {
  Journal journal(file(), {.most_waiting = 2});
  journal.begin();
  journal.put({.topic = "t", .payload = "p"});
  const auto first = journal.admit(a_command("1"), noon);
  EXPECT_TRUE(first);
  EXPECT_FALSE(journal.admit(a_command("2"), noon));
  EXPECT_EQ(journal.recognize(a_command("1", "sbgc/f/reply/other")).recognition, Recognition::full);
  journal.commit();
}

TEST_F(JournalTest, the_history_is_bounded_but_keeps_what_may_come_again) {
  Journal journal(file(), {.history = 3, .keep = milliseconds(1'000)});
  const auto do_one = [&](int number, Journal::Time now) {
    journal.begin();
    const auto id = journal.admit(a_command(std::to_string(number)), now);
    if (id) journal.finish(*id, "{}");
    journal.commit();
    return id.has_value();
  };
  const auto is_known = [&](int number) {
    return journal.recognize(a_command(std::to_string(number))).recognition != Recognition::unknown;
  };
  // All at the same time, so that none is old enough: twice the history, and no more.
  for (int i = 0; i < 6; ++i) EXPECT_TRUE(do_one(i, noon)) << i;
  EXPECT_FALSE(do_one(6, noon));
  EXPECT_TRUE(is_known(0));
  // Later, the oldest are forgotten.
  EXPECT_TRUE(do_one(7, noon + milliseconds(2'000)));
  EXPECT_FALSE(is_known(0));
  EXPECT_FALSE(is_known(3));
  EXPECT_TRUE(is_known(4));
  EXPECT_TRUE(is_known(7));
}

TEST_F(JournalTest, notices_leave_room_for_results) {
  Journal journal(file(), {.most_waiting = 2});
  journal.begin();
  for (int i = 0; i < 5; ++i) {
    journal.put({.kind = WaitingKind::notice, .topic = "t", .payload = "n"});
  }
  for (const char* const key : {"1", "2"}) {
    const auto id = journal.admit(a_command(key), noon);
    ASSERT_TRUE(id) << key;
    journal.finish(*id, "{}");
    journal.put({.kind = WaitingKind::result, .topic = "t", .payload = "r"});
  }
  EXPECT_FALSE(journal.admit(a_command("3"), noon));
  EXPECT_EQ(journal.waiting(), 2U);
  journal.remove(journal.waiting_after(0, 1).at(0).id);
  EXPECT_TRUE(journal.admit(a_command("3"), noon));
  journal.commit();
}

TEST_F(JournalTest, the_history_goes_on_after_the_clock_was_set_back) {
  Journal journal(file(), {.history = 1, .keep = milliseconds(1'000)});
  for (const auto now : {noon, noon, noon - std::chrono::hours(1)}) {
    journal.begin();
    const auto id = journal.admit(a_command(""), now);
    EXPECT_TRUE(id);
    if (id) journal.finish(*id, "{}");
    journal.commit();
  }
}

TEST_F(JournalTest, gimbals_in_motion_are_known_after_a_restart) {
  {
    Journal journal(file(), {});
    journal.begin();
    journal.set_moving("front", 1);
    journal.set_moving("front", 2);
    journal.set_moving("rear", 3);
    journal.set_at_rest("front", 1);  // command 2 still moves it
    journal.set_at_rest("rear", 4);
    journal.commit();
  }
  const Journal journal(file(), {});
  EXPECT_THAT(journal.moving(), ElementsAre(testing::Pair("front", 2)));
}

TEST_F(JournalTest, what_is_committed_survives_the_process) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    Journal journal(file(), {});
    journal.begin();
    journal.admit(a_command("committed"), noon);
    journal.put({.topic = "t", .payload = "committed"});
    journal.commit();
    journal.begin();
    journal.admit(a_command("open"), noon);
    journal.put({.topic = "t", .payload = "open"});
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  Journal journal(file(), {});
  ASSERT_THAT(journal.unfinished(), SizeIs(1));
  EXPECT_EQ(journal.unfinished().at(0).key, "committed");
  EXPECT_EQ(journal.unfinished().at(0).request, "move {}");
  ASSERT_THAT(journal.waiting_after(0, 9), SizeIs(1));
  EXPECT_EQ(journal.waiting(), 1U);
}

TEST_F(JournalTest, room_is_known_after_a_restart) {
  {
    Journal journal(file(), {});
    journal.begin();
    journal.admit(a_command("1"), noon);
    journal.put({.topic = "t", .payload = "p"});
    journal.commit();
  }
  Journal journal(file(), {.most_waiting = 2});
  journal.begin();
  EXPECT_FALSE(journal.admit(a_command("2"), noon));
  journal.commit();
}

TEST_F(JournalTest, two_processes_cannot_use_it) {
  const Journal journal(file(), {});
  EXPECT_THAT([&] { const Journal second(file(), {}); },
              ThrowsMessage<std::runtime_error>(HasSubstr("another process uses the journal")));
}

TEST_F(JournalTest, other_files_are_refused) {
  std::ofstream(file()) << "This is a text, and no database at all. It is long enough to be one.\n";
  EXPECT_THAT([&] { const Journal journal(file(), {}); },
              ThrowsMessage<std::runtime_error>(HasSubstr("file is not a database")));
  EXPECT_THAT([&] { const Journal journal(file() / "nowhere", {}); },
              ThrowsMessage<std::runtime_error>(HasSubstr("cannot be opened")));
}

}  // namespace
}  // namespace sbgc::tools
