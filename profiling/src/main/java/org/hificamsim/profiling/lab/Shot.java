package org.hificamsim.profiling.lab;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Texts;

/**
 * One picture to take.
 *
 * @param index its number from 0, which seeds its randomness
 * @param focalLength z, metres
 * @param distance d, metres
 */
record Shot(int index, LabObject object, double focalLength, double distance) {
  /** Every combination of object, focal length and distance. */
  static List<Shot> all(LabSettings settings) {
    List<Shot> shots = new ArrayList<>();
    for (LabObject object : settings.photographed()) {
      for (double focalLength : settings.focalLengths()) {
        for (double distance : settings.distances()) {
          shots.add(new Shot(shots.size(), object, focalLength, distance));
        }
      }
    }
    return shots;
  }

  /** A name for its files. */
  String name() {
    return Texts.format("%s-%02.0fmm-%04.1fm", object.name(), focalLength * 1000, distance);
  }
}
