// The hub's reactions to requests of clients.
#include <algorithm>
#include <utility>

#include "robot/core/json_library.h"
#include "robot/net/foxglove/hub.h"

namespace robot::net {
namespace {

std::string follows_shared(const std::string& topic) {
  return "subscribe: " + topic + " is of the shared playback only, and this client has a playhead of its own";
}

}  // namespace

void Hub::on_text(Client& client, std::string_view text) { handle(client, foxglove::parse_client_text(text)); }

void Hub::on_binary(Client& client, std::string_view bytes) { handle(client, foxglove::parse_client_binary(bytes)); }

void Hub::handle(Client& client, const Result<foxglove::ClientMessage>& message) {
  if (client.queue.finished()) return;
  if (!message) return complain(client, message.error());
  std::visit([&](const auto& content) { handle(client, content); }, *message);
}

void Hub::handle(Client& client, const foxglove::Subscribe& message) {
  for (const auto& item : message.subscriptions) subscribe(client, item);
}

void Hub::subscribe(Client& client, const foxglove::Subscribe::Item& item) {
  OfferedChannel* channel = channels_.find(item.channel);
  if (!channel) return complain(client, "subscribe: there is no channel " + std::to_string(item.channel));
  if (client.channel_of.contains(item.subscription))
    return complain(client, "subscribe: the subscription id " + std::to_string(item.subscription) + " is in use");
  if (std::ranges::any_of(client.channel_of, [&](const auto& taken) { return taken.second == channel->id; }))
    return complain(client, "subscribe: " + channel->info.topic + " is subscribed already");
  if (client.own && channel->derived && channel->derived->needs_others)
    return complain(client, follows_shared(channel->info.topic));

  client.channel_of[item.subscription] = channel->id;
  client.queue.subscribe(channel->id, item.subscription, channel->info.delivery);
  begin_carrying(client, *channel);
}

void Hub::handle(Client& client, const foxglove::Unsubscribe& message) {
  for (const std::uint32_t subscription : message.subscriptions) {
    const auto found = client.channel_of.extract(subscription);
    if (!found) {
      complain(client, "unsubscribe: there is no subscription " + std::to_string(subscription));
      continue;
    }
    client.queue.unsubscribe(found.mapped());
    end_carrying(client, *channels_.find(found.mapped()));
  }
}

void Hub::tell_parameters(Client& client, const std::vector<std::string>& names, const std::optional<std::string>& id) {
  std::vector<std::pair<std::string, ParameterValue>> values;
  for (const std::string& name : names)
    if (auto value = parameters_.get(name)) values.emplace_back(name, *std::move(value));
  say(client, foxglove::parameter_values(values, id));
}

void Hub::handle(Client& client, const foxglove::GetParameters& message) {
  tell_parameters(client, message.names.empty() ? parameters_.names() : message.names, message.id);
}

/// Calls `work`, which may wait for the disk, in the background, and then `then` with its result if the client is still
/// connected.
void Hub::in_turn(Client& client, std::function<std::string()> work,
                  std::function<void(Client&, const std::string&)> then) {
  constexpr int kMaxWaiting = 32;  // so that a client cannot fill our memory
  if (client.waiting_requests >= kMaxWaiting)
    return complain(client, "too many requests at once: expected at most " + std::to_string(kMaxWaiting));
  ++client.waiting_requests;
  const auto result = std::make_shared<std::string>();
  in_background_(
      Kind::order, [work = std::move(work), result] { *result = work(); },
      [client = client.weak_from_this(), then = std::move(then), result] {
        const std::shared_ptr<Client> present = client.lock();
        if (!present) return;
        --present->waiting_requests;
        then(*present, *result);
      });
}

/// Sets the values, all in one turn. The answer holds the values afterwards, which differ from the request if one was
/// refused.
void Hub::handle(Client& client, const foxglove::SetParameters& message) {
  std::vector<std::string> names;
  for (const auto& [name, value] : message.parameters) names.push_back(name);
  const auto problems = std::make_shared<std::vector<std::string>>();
  const auto tell = [this, names, problems, id = message.id](Client& present, const std::string&) {
    for (const std::string& problem : *problems) complain(present, problem);
    tell_parameters(present, names, id);
  };
  if (const std::string refusal = client.identity.context.refusal(); !refusal.empty() && !names.empty()) {
    const std::string more = names.size() > 1 ? " and " + std::to_string(names.size() - 1) + " more" : "";
    refuse(client, "parameter '" + names.front().substr(0, 100) + "'" + more + ": " + refusal);
    return tell(client, "");
  }
  in_turn(
      client,
      [this, wanted = message.parameters, problems] {
        for (const auto& [name, value] : wanted) {
          const Result<void> set =
              value ? parameters_.set(name, *value)
                    : Error{"parameter '" + name.substr(0, 100) + "': expected true, false, a number or a text"};
          if (!set) problems->push_back(set.error());
        }
        return std::string();
      },
      tell);
}

void Hub::handle(Client& client, const foxglove::WatchParameters& message) {
  if (message.names.empty()) {
    client.watches_all_parameters = message.watch;
    client.watched_parameters.clear();
  }
  // only names that exist are kept: a client cannot fill our memory
  for (const std::string& name : message.names) {
    if (!message.watch)
      client.watched_parameters.erase(name);
    else if (parameters_.get(name))
      client.watched_parameters.insert(name);
  }
}

void Hub::handle(Client& client, const foxglove::ServiceCall& message) {
  if (!services_.has(message.service)) {
    const std::string sentence = "there is no service " + std::to_string(message.service);
    say(client, foxglove::service_call_failure(message.service, message.call, sentence));
    return complain(client, sentence);  // viewers show this one
  }
  if (message.encoding != "json")
    return answer(client, message, failure("service: expected the encoding 'json'").dump());
  ClientContext context = client.identity.context;
  context.asked_ns = monotonic_ns();
  if (client.own) context.playhead_ns = client.own->state().time_ns;
  // a refusal is sent at once, without waiting in the queue
  if (const std::string refusal = services_.refusal(message.service, context); !refusal.empty())
    return answer(client, message, refused(refusal, context).dump());
  switch (services_.whom(message.service)) {
    case Services::For::everybody:
      return answer(client, message, services_.call(message.service, message.payload, context));
    case Services::For::questions: return ask(client, message);
    case Services::For::control: break;
  }
  in_turn(
      client, [this, message, context] { return services_.call(message.service, message.payload, context); },
      [this, message](Client& present, const std::string& text) { answer(present, message, text); });
}

void Hub::ask(Client& client, const foxglove::ServiceCall& question) {
  constexpr std::size_t kMostQuestions = 2;
  if (questions_.size() >= kMostQuestions)
    return answer(client, question,
                  failure(services_.name(question.service) +
                          ": another question is running and one more waits: ask again when they are answered")
                      .dump());
  questions_.push_back({.client = client.weak_from_this(), .call = question, .asked_ns = monotonic_ns()});
  if (client.own) questions_.back().playhead_ns = client.own->state().time_ns;
  if (questions_.size() == 1) run_question();
}

/// Answers the first question in the background, and then the next.
void Hub::run_question() {
  const std::shared_ptr<Client> asker = questions_.front().client.lock();
  ClientContext context = asker ? asker->identity.context : ClientContext();  // as it is now: a game may have begun
  context.asked_ns = questions_.front().asked_ns;
  context.playhead_ns = questions_.front().playhead_ns;
  const auto text = std::make_shared<std::string>();
  in_background_(
      Kind::question,
      [this, call = questions_.front().call, context, text] {
        *text = services_.call(call.service, call.payload, context);
      },
      [this, text] {
        const PendingCall done = std::move(questions_.front());
        questions_.pop_front();
        if (const std::shared_ptr<Client> present = done.client.lock()) answer(*present, done.call, *text);
        if (!questions_.empty()) run_question();
      });
}

void Hub::answer(Client& client, const foxglove::ServiceCall& call, const std::string& text) {
  say_binary(client, foxglove::service_response(call.service, call.call, "json", text));
}

void Hub::handle(Client& client, const foxglove::ClientPublish&) {
  complain(client, "this server takes no messages from clients");
}

void Hub::handle(Client& client, const foxglove::Unsupported& message) {
  complain(client, "'" + message.op + "' needs a capability that this server does not announce");
}

}  // namespace robot::net
