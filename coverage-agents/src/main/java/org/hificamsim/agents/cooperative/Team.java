package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.channel.Channel;
import org.hificamsim.core.channel.ChannelModel;
import org.hificamsim.core.channel.MessageBits;
import org.hificamsim.core.channel.Post;
import org.hificamsim.core.channel.Stations;
import org.hificamsim.core.policy.BeliefListener;
import org.hificamsim.core.policy.NetworkView;

/**
 * The cameras of a network, their minds and their messages. Over a perfect channel all cameras
 * believe the same, and share one {@link Mind}.
 */
final class Team {
  private final boolean shared;
  private final Mind[] minds;
  private final Site site;
  private final Channel channel;
  private final Post<SightingReport> reportPost;
  private final Post<int[]> choicePost;
  private final int cameras;

  /** The view that each camera chose in this step. */
  private final int[] chosenViews;

  /** The number of messages that each camera sent in this step. */
  private final int[] messagesInStep;

  /** Whether the last bid arrived in time, by sender and receiver. */
  private final boolean[] bidHasArrived;

  /** Whether any report or choice arrived in this step, by sender and receiver. */
  private final boolean[] messageArrived;

  private final Stations stations;
  private long messages;
  private long bits;

  /**
   * @param individual whether each camera has its own mind
   */
  Team(Parameters parameters, Site site, NetworkView network, boolean individual) {
    this.site = site;
    stations = network;
    cameras = network.cameras();
    shared = !individual || cameras <= 1;
    boolean perfect = network.channel().isPerfect();
    // Channel.PERFECT knows no cameras, and so cannot carry messages between separate minds.
    channel = perfect ? new Channel(ChannelModel.PERFECT, network, 0) : network.channel();
    reportPost = new Post<>(network, channel);
    choicePost = new Post<>(network, channel);
    chosenViews = new int[cameras];
    messagesInStep = new int[cameras];
    bidHasArrived = new boolean[shared ? 0 : cameras * cameras];
    messageArrived = new boolean[bidHasArrived.length];
    Worth worth = new Worth(network.objective(), parameters.lead(), parameters.further());
    minds = new Mind[shared ? Math.min(1, cameras) : cameras];
    Arrays.setAll(minds, camera -> new Mind(parameters, worth, site, network));
  }

  /** All minds: one for each camera, or one that all cameras share. */
  Mind[] minds() {
    return minds;
  }

  /** The mind of a camera. */
  Mind mind(int camera) {
    return minds[shared ? 0 : camera];
  }

  /** The plan in the mind of a camera. */
  Plan plan(int camera) {
    return mind(camera).plan();
  }

  /** Lets all cameras send what they see, form a belief from what arrives, and begin a plan. */
  void share(NetworkView network, SightingReport[] reports) {
    site.refresh(network);
    Arrays.fill(chosenViews, Plan.NONE);
    Arrays.fill(messagesInStep, 0);
    Arrays.fill(messageArrived, false);
    for (int camera = 0; camera < cameras; camera++) {
      if (network.online(camera)) {
        count(camera, reports[camera].bits(network));
      }
    }
    if (shared) {
      giveToAll(reports);
    } else {
      send(network, reports);
    }
    for (Mind mind : minds) {
      mind.believe(network);
      mind.beginPlan(network);
    }
  }

  private void giveToAll(SightingReport[] reports) {
    for (Mind mind : minds) {
      for (SightingReport report : reports) {
        mind.receive(report);
      }
    }
  }

  private void send(NetworkView network, SightingReport[] reports) {
    for (int camera = 0; camera < cameras; camera++) {
      if (network.online(camera)) {
        SightingReport report = reports[camera].copy();
        minds[camera].receive(report);
        reportPost.broadcast(camera, report.bits(network), report);
      }
    }
    reportPost.deliver(
        (sender, receiver, sentAt, report) -> {
          noteArrival(sender, receiver);
          minds[receiver].receive(report);
        });
    deliverChoices(network);
    for (Mind mind : minds) {
      mind.sortReports();
    }
  }

  private void deliverChoices(NetworkView network) {
    choicePost.deliver(
        (sender, receiver, sentAt, way) -> {
          noteArrival(sender, receiver);
          minds[receiver].learnChoice(sender, way, sentAt, network.step());
        });
  }

  private void noteArrival(int sender, int receiver) {
    messageArrived[sender * cameras + receiver] = true;
  }

  /**
   * Lets a camera choose a view, and send the others its way unless they know it already.
   *
   * @return whether the camera did not choose this view in this step before
   */
  boolean choose(NetworkView network, int camera, int view) {
    boolean changed = chosenViews[camera] != view;
    chosenViews[camera] = view;
    int[] way = plan(camera).wayTo(network, camera, view);
    boolean known = mind(camera).knowsChoice(camera, way, network.step());
    mind(camera).learnChoice(camera, way, network.step(), network.step());
    if (!known) {
      sendChoice(network, camera, way);
    }
    return changed;
  }

  private void sendChoice(NetworkView network, int camera, int[] way) {
    int length =
        MessageBits.address(cameras) + way.length * (1 + MessageBits.of(network.views(camera)));
    count(camera, length);
    if (!shared) {
      choicePost.broadcast(camera, length, way.clone());
      deliverChoices(network);
    }
  }

  /** Lets a camera choose the view that its plan has for it, without a message. */
  void followPlan(int camera) {
    chosenViews[camera] = plan(camera).view(camera);
  }

  /**
   * Lets a camera send the others a bid of this many numbers. The numbers themselves stay with the
   * {@link Agreement}; what is simulated is where they arrive ({@link #bidHasArrived}).
   */
  void bid(int camera, int numbers) {
    int length = MessageBits.address(cameras) + numbers * MessageBits.REAL;
    count(camera, length);
    if (!shared) {
      boolean sent = channel.send(camera, length);
      stations.radio().send(camera, sent ? length : 0);
      for (int receiver = 0; receiver < cameras; receiver++) {
        boolean arrived = sent && channel.delay(camera, receiver) == 0;
        if (arrived && receiver != camera && stations.online(receiver)) {
          stations.radio().receive(receiver, length);
        }
        bidHasArrived[camera * cameras + receiver] = arrived;
      }
    }
  }

  /** Whether the last bid of a camera arrived at another one in time. */
  boolean bidHasArrived(int sender, int receiver) {
    return shared || bidHasArrived[sender * cameras + receiver];
  }

  /** Counts a message; separate minds tell the radio when they post it. */
  private void count(int camera, int length) {
    if (shared) {
      stations.radio().send(camera, length);
      stations.radio().receiveAll(camera, length, stations);
    }
    messagesInStep[camera]++;
    messages++;
    bits += length;
  }

  /** Reports who sent how many messages in this step, and who received any. */
  void reportMessages(NetworkView network, BeliefListener listener) {
    for (int sender = 0; sender < cameras; sender++) {
      listener.sent(sender, messagesInStep[sender]);
      for (int receiver = 0; receiver < cameras; receiver++) {
        if (received(network, sender, receiver)) {
          listener.received(sender, receiver);
        }
      }
    }
  }

  private boolean received(NetworkView network, int sender, int receiver) {
    return shared
        ? receiver != sender && messagesInStep[sender] > 0 && network.online(receiver)
        : messageArrived[sender * cameras + receiver];
  }

  /** The identity switches so far in the tracks of a mind, mean over minds; 0 without cameras. */
  double identitySwitches() {
    return Arrays.stream(minds)
        .mapToLong(mind -> mind.belief().identitySwitches())
        .average()
        .orElse(0);
  }

  /** The view that a camera chose in this step. */
  int chosenView(int camera) {
    return chosenViews[camera];
  }

  /** The number of messages sent since the beginning of the run. */
  long messages() {
    return messages;
  }

  /** The length of all these messages, in bits. */
  long bits() {
    return bits;
  }
}
