package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.channel.Channel;
import org.hificamsim.core.channel.ChannelModel;
import org.hificamsim.core.channel.MessageBits;
import org.hificamsim.core.channel.Post;
import org.hificamsim.core.policy.BeliefListener;
import org.hificamsim.core.policy.NetworkView;

/**
 * The cameras of a network with what each believes, and all that they say to each other. Over a
 * perfect channel all believe the same, and have one {@link Mind}.
 */
final class Team {
  private final Mind[] minds;
  private final Site site;
  private final Channel channel;
  private final Post<SightingReport> reports;
  private final Post<Integer> choices;
  private final int[] chosen; // in this step
  private final int[] told; // messages in this step, by sender
  private final boolean[] heard; // by sender and receiver: who received the last bid
  private final boolean[] reached; // by sender and receiver: in this step
  private long messages;
  private long bits;

  /**
   * @param each whether each camera has a mind of its own
   */
  Team(Parameters parameters, Site site, NetworkView network, boolean each) {
    this.site = site;
    boolean perfect = network.channel().isPerfect();
    channel = perfect ? new Channel(ChannelModel.PERFECT, network, 0) : network.channel();
    reports = new Post<>(network, channel);
    choices = new Post<>(network, channel);
    chosen = new int[network.cameras()];
    told = new int[chosen.length];
    heard = new boolean[each ? chosen.length * chosen.length : 0];
    reached = new boolean[heard.length];
    Worth worth = new Worth(network.objective(), parameters.lead());
    minds = new Mind[each ? chosen.length : Math.min(1, chosen.length)];
    Arrays.setAll(minds, camera -> new Mind(parameters, worth, site, network));
  }

  /** How many minds the cameras have between them. */
  int minds() {
    return minds.length;
  }

  private boolean each() {
    return minds.length > 1;
  }

  /** The mind of a camera. */
  Mind mind(int camera) {
    return minds[each() ? camera : 0];
  }

  Plan plan(int camera) {
    return mind(camera).plan();
  }

  /** All tell each other what they see, come to a belief, and begin to plan. */
  void share(NetworkView network, SightingReport[] seen) {
    site.refresh(network);
    Arrays.fill(chosen, Plan.NONE);
    Arrays.fill(told, 0);
    Arrays.fill(reached, false);
    for (int camera = 0; camera < seen.length; camera++) {
      if (network.online(camera)) {
        count(camera, seen[camera].bits(network));
      }
    }
    if (each()) {
      send(network, seen);
    } else if (minds.length == 1) {
      for (SightingReport report : seen) {
        minds[0].receive(report);
      }
      minds[0].believe(network);
      minds[0].plan(network);
    }
  }

  private void send(NetworkView network, SightingReport[] seen) {
    for (int camera = 0; camera < seen.length; camera++) {
      if (network.online(camera)) {
        SightingReport report = seen[camera].copy();
        minds[camera].receive(report);
        reports.broadcast(camera, report.bits(network), report);
      }
    }
    reports.deliver(
        (from, to, sent, report) -> {
          reach(from, to);
          minds[to].receive(report);
        });
    deliverChoices(network);
    for (int camera = 0; camera < minds.length; camera++) {
      minds[camera].sort();
      minds[camera].believe(network);
      minds[camera].plan(network);
    }
  }

  private void deliverChoices(NetworkView network) {
    choices.deliver(
        (from, to, sent, choice) -> {
          reach(from, to);
          minds[to].hear(from, choice, sent, network.step());
        });
  }

  private void reach(int from, int to) {
    reached[from * chosen.length + to] = true;
  }

  /**
   * A camera chooses a view, and tells the others.
   *
   * @return whether it is another one than it chose in this step before
   */
  boolean choose(NetworkView network, int camera, int view) {
    boolean changed = chosen[camera] != view;
    chosen[camera] = view;
    mind(camera).hear(camera, view, network.step(), network.step());
    if (changed) {
      tell(network, camera, view);
    }
    return changed;
  }

  private void tell(NetworkView network, int camera, int view) {
    int length = MessageBits.address(chosen.length) + MessageBits.of(network.views(camera));
    count(camera, length);
    if (each()) {
      choices.broadcast(camera, length, view);
      deliverChoices(network);
    }
  }

  /** A camera does its part of a plan without a message to others. */
  void follow(int camera) {
    chosen[camera] = plan(camera).view(camera);
  }

  /** A camera sends the others this many numbers. */
  void bid(NetworkView network, int camera, int numbers) {
    int length = MessageBits.address(chosen.length) + numbers * MessageBits.REAL;
    count(camera, length);
    if (each()) {
      boolean sent = channel.send(camera, length);
      for (int to = 0; to < chosen.length; to++) {
        heard[camera * chosen.length + to] = sent && channel.delay(camera, to) == 0;
      }
    }
  }

  /** Whether a camera received the last bid of another one in time. */
  boolean hears(int camera, int other) {
    return !each() || heard[other * chosen.length + camera];
  }

  private void count(int camera, int length) {
    told[camera]++;
    messages++;
    bits += length;
  }

  /** Reports who sent how many messages in this step, and who received them. */
  void tell(NetworkView network, BeliefListener listener) {
    for (int from = 0; from < told.length; from++) {
      listener.told(from, told[from]);
      for (int to = 0; to < told.length; to++) {
        boolean all = !each() && to != from && told[from] > 0 && network.online(to);
        if (all || (each() && reached[from * told.length + to])) {
          listener.heard(from, to);
        }
      }
    }
  }

  /** The view that a camera chose in this step. */
  int chosen(int camera) {
    return chosen[camera];
  }

  long messages() {
    return messages;
  }

  long bits() {
    return bits;
  }
}
