package org.hificamsim.network.agent;

import java.util.Arrays;

/** The bids for one target, in the order of CamSim's hash map (behaviour 4.5). */
final class Bids {
  private final HashOrder bidders = new HashOrder();
  private double[] values = {};

  /**
   * Records a bid, unless the camera has already bid.
   *
   * @param hash orders the bids; the same for all to keep them in the order of arrival
   */
  void add(int camera, double value, int hash) {
    if (!hasBid(camera)) {
      values = camera < values.length ? values : Arrays.copyOf(values, camera + 1);
      values[camera] = value;
      bidders.add(camera, hash);
    }
  }

  private boolean hasBid(int camera) {
    for (int i = 0; i < bidders.size(); i++) {
      if (bidders.get(i) == camera) {
        return true;
      }
    }
    return false;
  }

  int count() {
    return bidders.size();
  }

  int bidder(int index) {
    return bidders.get(index);
  }

  double value(int index) {
    return values[bidders.get(index)];
  }

  void clear() {
    bidders.clear();
  }
}
