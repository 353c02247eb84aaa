package org.hificamsim.core.channel;

import org.hificamsim.core.Draw;
import org.hificamsim.core.InputException;
import org.hificamsim.core.registry.Options;

/**
 * The law by which messages are lost: independently, or in bursts by the model of Gilbert (1960)
 * and Elliott (1963), in which a link is in a good or a bad state and may change between steps.
 *
 * @param mean the long-term share of messages that are lost, in [0, 1]
 * @param burst the mean duration of the bad state, 1 step or more; 0 for independent losses
 * @param h the share that arrives in the bad state, in [0, 1)
 * @param k the share that arrives in the good state, in (h, 1]
 */
record Loss(double mean, double burst, double h, double k) {
  private static final double MAX_BURST = 10_000;

  static Loss from(Options options) {
    double mean = options.number("loss", 0, 0, 1, "the share of the messages that is lost");
    double burst =
        options.number(
            "burst", 0, 0, MAX_BURST, "steps that losses last (Gilbert-Elliott); 0: one by one");
    double h = options.number("h", 0, 0, 1, "with burst: what arrives in the bad state");
    double k = options.number("k", 1, 0, 1, "with burst: what arrives in the good state");
    return new Loss(mean, burst, h, k).checked();
  }

  private Loss checked() {
    if (burst == 0 ? h != 0 || k != 1 : burst < 1) {
      throw invalid("burst is " + burst, "1 or more steps, or 0 without h and k");
    } else if (burst > 0 && !(h < k && mean >= 1 - k && mean < 1 - h && chanceOfBad() < 1)) {
      String lost = "a loss from 1 - k to 1 - h, with bursts that leave room for it";
      throw invalid("loss is %s with burst=%s, h=%s, k=%s".formatted(mean, burst, h, k), lost);
    }
    return this;
  }

  private static InputException invalid(String found, String expected) {
    return new InputException("channel: " + found + ", expected " + expected);
  }

  boolean isNone() {
    return mean == 0;
  }

  /** The chance p that a good link is bad in the next step. */
  private double chanceOfBad() {
    double bad = (mean - 1 + k) / (k - h);
    return chanceOfGood() * bad / (1 - bad);
  }

  /** The chance r that a bad link is good in the next step. */
  private double chanceOfGood() {
    return 1 / burst;
  }

  /**
   * Whether a message is lost.
   *
   * @param link the key of all draws of the link
   * @param draw the random number of the message, in [0, 1)
   */
  boolean loses(long link, long step, double draw) {
    double lost = burst == 0 ? mean : 1 - (isBad(link, step) ? h : k);
    return draw < lost;
  }

  /**
   * Whether a link is in its bad state. It looks back to the last step whose draw decides the state
   * regardless of the state before, so that no state has to be kept.
   */
  private boolean isBad(long link, long step) {
    double staysBad = 1 - chanceOfGood();
    double turnsBad = chanceOfBad();
    boolean inverted = false;
    for (long earlier = step; ; earlier--) {
      double draw = Draw.unit(Draw.key(link, earlier));
      if (draw < Math.min(turnsBad, staysBad)) {
        return !inverted;
      } else if (draw >= Math.max(turnsBad, staysBad)) {
        return inverted;
      }
      inverted ^= turnsBad > staysBad;
    }
  }

  /** The loss as users write it; empty without losses. */
  String text() {
    return isNone()
        ? ""
        : ChannelModel.option("loss", mean, 0)
            + ChannelModel.option(",burst", burst, 0)
            + ChannelModel.option(",h", h, 0)
            + ChannelModel.option(",k", k, 1);
  }
}
