// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/faults/fault_keys.hpp"

namespace arcbid::yaml {
namespace {

constexpr double longest_delay_ms = 600'000;
constexpr double farthest_m = 1e6;

Kind<double> share() {
  return number<double>(0, 1);
}

Keys<LinkFault> loss_keys() {
  using F = LinkFault;
  return {
      field<F>("loss", &F::loss, share(), "Share of messages lost, each by itself."),
      field<F>("loss_per_kb", &F::loss_per_kb, share(),
               "Further share lost for each 1000 bytes of the message."),
      field<F>("burst", &F::burst, optional_of(mapping(burst_keys())),
               "Loss in bursts (Gilbert-Elliott)."),
      field<F>("reach", &F::reach, optional_of(mapping(reach_keys())),
               "Loss that grows with the distance between the agents' homes."),
      field<F>("obstacles", &F::obstacles, list_of(mapping(obstacle_keys()), 1000, "boxes"),
               "Boxes; nothing passes where the line between the homes meets one."),
      field<F>("cut", &F::cut, boolean(), "Nothing passes."),
      field<F>("flap_s", &F::flap_ns, seconds(0, longest_s),
               "With `cut`: it holds in every other stretch this long, the first one included; "
               "0: all the time."),
  };
}

Keys<LinkFault> timing_keys() {
  using F = LinkFault;
  return {
      field<F>("delay", &F::delay, optional_of(mapping(delay_keys())),
               "Each message takes its own time, so that messages overtake each other."),
      field<F>("duplicate", &F::duplicate, share(),
               "Share of messages that come twice, each copy with its own delay."),
      field<F>("stale", &F::stale, share(), "Share of messages that come again after `stale_s`."),
      field<F>("stale_s", &F::stale_ns, seconds(0, longest_s),
               "How much later a stale copy comes."),
      field<F>("capacity", &F::capacity, optional_of(mapping(capacity_keys())),
               "The link carries so much and no more."),
      field<F>("clog", &F::clog, boolean(),
               "Messages are held back until the window's end, then come all at once."),
  };
}

}  // namespace

const Keys<LinkFault>& link_keys() {
  using F = LinkFault;
  static const Keys<F> keys = [] {
    Keys<F> all = {
        field<F>("from", &F::from, agent_ids(), "Who sends."),
        field<F>("to", &F::to, agent_ids(), "Who receives."),
        field<F>("both_ways", &F::both_ways, boolean(), "Also the links from `to` to `from`."),
        field<F>(
            "from_s", [](auto& f) -> auto& { return f.when.start_ns; }, seconds(0, longest_s),
            "When the fault begins."),
        field<F>(
            "to_s", [](auto& f) -> auto& { return f.when.end_ns; }, end_seconds(),
            "When it ends; absent: never, or at `until_s`."),
    };
    for (const Keys<F>& more : {loss_keys(), timing_keys()})
      all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  return keys;
}

const Keys<Burst>& burst_keys() {
  using B = Burst;
  static const Keys<B> keys = {
      field<B>("mean_loss", &B::mean_loss, share(), "Share of messages lost in the long run."),
      field<B>("mean_length", &B::mean_length, number<double>(1, 10'000),
               "Mean number of consecutive messages in the bad state."),
      field<B>("good_loss", &B::good_loss, share(), "Loss in the good state."),
      field<B>("bad_loss", &B::bad_loss, share(), "Loss in the bad state."),
  };
  return keys;
}

const Keys<Delay>& delay_keys() {
  using D = Delay;
  static const Keys<D> keys = {
      field<D>("kind", &D::kind,
               choice<D::Kind>({{"fixed", D::Kind::fixed},
                                {"uniform", D::Kind::uniform},
                                {"exponential", D::Kind::exponential}}),
               "How delays are spread."),
      field<D>("least_ms", &D::least_ns, milliseconds(0, longest_delay_ms),
               "The delay, when fixed; otherwise the least one."),
      field<D>("most_ms", &D::most_ns, milliseconds(0, longest_delay_ms),
               "The greatest delay, when uniform."),
      field<D>("mean_ms", &D::mean_ns, milliseconds(0, longest_delay_ms),
               "The mean above `least_ms`, when exponential."),
  };
  return keys;
}

const Keys<Capacity>& capacity_keys() {
  using C = Capacity;
  static const Keys<C> keys = {
      field<C>("bytes_per_s", &C::bytes_per_s, number<double>(1, 1e12),
               "How fast messages go out, one behind the other.", true),
      field<C>("queue_bytes", &C::queue_bytes, byte_count(),
               "How much may wait; what does not fit is lost. 0: no limit."),
  };
  return keys;
}

const Keys<Reach>& reach_keys() {
  using R = Reach;
  static const Keys<R> keys = {
      field<R>("full_m", &R::full_m, number<double>(0, farthest_m),
               "No loss up to this distance; beyond, it grows evenly."),
      field<R>("none_m", &R::none_m, number<double>(0, farthest_m), "Nothing passes from here on.",
               true),
  };
  return keys;
}

const Keys<Obstacle>& obstacle_keys() {
  using O = Obstacle;
  static const Keys<O> keys = {
      field<O>("least_m", &O::least_m, position(farthest_m), "The box's lower corner.", true),
      field<O>("most_m", &O::most_m, position(farthest_m), "Its upper corner.", true),
  };
  return keys;
}

}  // namespace arcbid::yaml
