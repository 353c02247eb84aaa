package org.hificamsim.agents.observation;

import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.hificamsim.core.policy.NetworkView;

/**
 * A scale for where cameras stand: the middle of those that are online at first is 0, and the
 * outermost of them, in x or y, is at 1 or -1.
 */
final class Standpoints {
  private final double middleX;
  private final double middleY;
  private final double half;

  Standpoints(NetworkView network) {
    double left = least(network, network::cameraX);
    double right = -least(network, camera -> -network.cameraX(camera));
    double bottom = least(network, network::cameraY);
    double top = -least(network, camera -> -network.cameraY(camera));
    middleX = (left + right) / 2;
    middleY = (bottom + top) / 2;
    half = Math.max(Math.max(right - left, top - bottom) / 2, Double.MIN_NORMAL);
  }

  private static double least(NetworkView network, IntToDoubleFunction of) {
    return IntStream.range(0, network.cameras())
        .filter(network::online)
        .mapToDouble(of)
        .min()
        .orElse(0);
  }

  float x(double metres) {
    return Bounds.signed((metres - middleX) / half);
  }

  float y(double metres) {
    return Bounds.signed((metres - middleY) / half);
  }

  /** A distance in x or y: half the scale, so that the outermost are at 1 from each other. */
  float between(double metres) {
    return Bounds.signed(metres / half / 2);
  }
}
