#include "talus/run/rank_messages.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "talus/core/bytes.hpp"

namespace talus::project {

MessageKind kind_of(const Ranks::Message& message) {
  ByteReader in(message.bytes);
  const auto kind = in.get<std::uint8_t>();
  expect_bytes(kind <= static_cast<std::uint8_t>(MessageKind::cannot), "a message of no known kind");
  return MessageKind{kind};
}

std::string_view content_of(const Ranks::Message& message) { return std::string_view(message.bytes).substr(1); }

std::string message_of(MessageKind kind, std::string_view content) {
  std::string bytes(1, static_cast<char>(kind));
  bytes += content;
  return bytes;
}

std::string message_of(const Hello& hello) {
  ByteWriter out;
  out.put(static_cast<std::uint8_t>(MessageKind::hello));
  out.text(hello.version);
  out.text(hello.machine);
  out.put(static_cast<std::int32_t>(hello.threads));
  out.text(json_text(hello.description));
  return out.take();
}

Hello hello_from(std::string_view content) {
  ByteReader in(content);
  Hello hello;
  hello.version = in.text();
  hello.machine = in.text();
  if (hello.version != TALUS_VERSION) return hello;
  hello.threads = in.get<std::int32_t>();
  hello.description = description_from(in.text());
  in.expect_end();
  return hello;
}

std::string message_of(const RockRange& rocks) {
  ByteWriter out;
  out.put(static_cast<std::uint8_t>(MessageKind::rocks));
  out.put(rocks.first);
  out.put(rocks.last);
  return out.take();
}

RockRange rocks_from(std::string_view content) {
  ByteReader in(content);
  RockRange rocks;
  rocks.first = in.get<std::uint64_t>();
  rocks.last = in.get<std::uint64_t>();
  in.expect_end();
  return rocks;
}

std::string message_of(const DoneBlock& block) {
  ByteWriter out;
  out.put(static_cast<std::uint8_t>(MessageKind::block));
  out.put(block.rocks.first);
  out.put(block.rocks.last);
  out.count(block.texts.size());
  for (const std::string& text : block.texts) out.text(text);
  return out.take();
}

DoneBlock block_from(std::string_view content) {
  ByteReader in(content);
  DoneBlock block;
  block.rocks.first = in.get<std::uint64_t>();
  block.rocks.last = in.get<std::uint64_t>();
  for (std::size_t left = in.count(sizeof(std::uint64_t)); left > 0; --left) block.texts.push_back(in.text());
  in.expect_end();
  return block;
}

std::string done_message(std::uint64_t next_rock) {
  ByteWriter out;
  out.put(static_cast<std::uint8_t>(MessageKind::done));
  out.put(next_rock);
  return out.take();
}

std::uint64_t next_rock_from(std::string_view content) { return ByteReader(content).get<std::uint64_t>(); }

std::string message_of(const Cannot& cannot) {
  ByteWriter out;
  out.put(static_cast<std::uint8_t>(MessageKind::cannot));
  out.text(cannot.machine);
  out.text(cannot.text);
  out.put(static_cast<std::int32_t>(cannot.exit_code));
  return out.take();
}

Cannot cannot_from(std::string_view content) {
  ByteReader in(content);
  Cannot cannot;
  cannot.machine = in.text();
  cannot.text = in.text();
  cannot.exit_code = in.get<std::int32_t>();
  in.expect_end();
  return cannot;
}

std::string leave_message(int exit_code) {
  ByteWriter out;
  out.put(static_cast<std::uint8_t>(MessageKind::leave));
  out.put(static_cast<std::int32_t>(exit_code));
  return out.take();
}

int exit_code_from(std::string_view content) { return ByteReader(content).get<std::int32_t>(); }

std::chrono::microseconds Naps::next(Ranks& ranks) {
  if (ranks.unsent() > 0) return shortest;
  return std::exchange(next_, std::min(longest, 2 * next_));
}

bool GatherInbox::add(const Ranks::Message& message) {
  switch (kind_of(message)) {
    case MessageKind::ask_for_sums:
      is_asked_ = true;
      return true;
    case MessageKind::piece_of_sums:
      sums_ += content_of(message);
      return true;
    case MessageKind::end_of_sums:
      are_whole_ = true;
      return true;
    default:
      return false;
  }
}

namespace {

/// Passes the bytes to `send` in pieces.
void save_sums(std::span<SummingObserver* const> observers, const std::function<void(std::string_view)>& send) {
  ByteWriter out(send);
  for (SummingObserver* observer : observers) observer->save(out);
  out.flush();
}

void merge_sums(const std::string& bytes, std::span<SummingObserver* const> observers) {
  ByteReader in(bytes);
  for (SummingObserver* observer : observers) observer->merge_saved(in);
  in.expect_end();
}

}  // namespace

void gather_sums(Ranks& ranks, GatherInbox& inbox, std::span<SummingObserver* const> observers,
                 const std::function<void(const Ranks::Message&)>& handle_other) {
  Naps naps;
  const auto poll = [&] {
    const auto message = ranks.receive();
    if (!message) {
      std::this_thread::sleep_for(naps.next(ranks));
      return;
    }
    naps.found_something();
    if (!inbox.add(*message)) handle_other(*message);
  };
  for (int step = 1; step < ranks.size(); step *= 2) {
    if ((ranks.rank() & step) != 0) {
      const int to = ranks.rank() - step;
      while (!inbox.is_asked_) poll();
      inbox.is_asked_ = false;
      save_sums(observers, [&](std::string_view piece) {
        constexpr std::size_t most_unsent = 16U << 20;
        ranks.send(to, message_of(MessageKind::piece_of_sums, piece));
        while (ranks.unsent() > most_unsent) poll();
      });
      ranks.send(to, message_of(MessageKind::end_of_sums));
      return;
    }
    const int other = ranks.rank() + step;
    if (other >= ranks.size()) continue;
    ranks.send(other, message_of(MessageKind::ask_for_sums));
    while (!inbox.are_whole_) poll();
    inbox.are_whole_ = false;
    merge_sums(std::exchange(inbox.sums_, {}), observers);
  }
}

}  // namespace talus::project
