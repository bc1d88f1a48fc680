// Compiled, not run: a conversation in the protocol of the generated headers.

#include <sbgc/detector.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/session.hpp>

void talk(sbgc::Session& session, sbgc::Instant now);

void talk(sbgc::Session& session, sbgc::Instant now) {
  sbgc::AllMessages::for_each([&]<class M>(sbgc::Type<M>) {
    if constexpr (M::direction != sbgc::Direction::from_board) session.send(M{});
  });
  static_cast<void>(session.poll(now, [](const sbgc::Event&) {}));
  if constexpr (sbgc::Detector::lines != 0) {
    static sbgc::Detector detector;
    static_cast<void>(detector.next(now));
  }
}
