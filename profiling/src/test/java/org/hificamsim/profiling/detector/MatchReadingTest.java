package org.hificamsim.profiling.detector;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.profiling.dataset.Patch;
import org.hificamsim.profiling.opencv.OpenCv;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.opencv.core.DMatch;
import org.opencv.core.KeyPoint;
import org.opencv.core.Mat;

class MatchReadingTest {
  private static final int FEATURES = 100;
  private static final Patch PATCH = new Patch(200, 100, 50, 50);

  private final List<DMatch> matches = new ArrayList<>();
  private final KeyPoint[] template = new KeyPoint[FEATURES];
  private final KeyPoint[] photo = new KeyPoint[FEATURES];

  @BeforeAll
  static void load() {
    OpenCv.load();
  }

  /** Creates 40 matches that shrink the template onto the patch, and 30 at random outside it. */
  private void scatter() {
    SplittableRandom random = new SplittableRandom(7);
    for (int i = 0; i < FEATURES; i++) {
      float x = random.nextInt(500);
      float y = random.nextInt(500);
      template[i] = new KeyPoint(x, y, 1);
      photo[i] =
          i < 40
              ? new KeyPoint(200 + x / 10, 100 + y / 10, 1)
              : new KeyPoint(300 + random.nextInt(500), random.nextInt(600), 1);
      if (i < 70) {
        matches.add(new DMatch(i, i, 1));
      }
    }
  }

  @Test
  void locatedAndRansacIgnoreFalseMatches() {
    scatter();
    assertEquals(0.7, confidence(MatchReading.ANYWHERE, PATCH));
    assertEquals(0.4, confidence(MatchReading.LOCATED, PATCH));
    assertEquals(0.4, confidence(MatchReading.RANSAC, PATCH), 0.03);
  }

  @Test
  void onlyLocatedDependsOnThePatch() {
    scatter();
    Patch elsewhere = new Patch(0, 0, 50, 50);
    assertEquals(0, confidence(MatchReading.LOCATED, elsewhere));
    assertEquals(0.4, confidence(MatchReading.RANSAC, elsewhere), 0.03);
  }

  @Test
  void ransacNeedsFourMatches() {
    scatter();
    matches.subList(3, matches.size()).clear();
    assertEquals(0, confidence(MatchReading.RANSAC, PATCH));
    matches.clear();
    assertEquals(0, confidence(MatchReading.ANYWHERE, PATCH));
  }

  @Test
  void detectorNamesSelectTheReading() {
    assertEquals(MatchReading.ANYWHERE, MatchReading.of("orb"));
    assertEquals(MatchReading.LOCATED, MatchReading.of("sift-located"));
    assertEquals(MatchReading.RANSAC, MatchReading.of("surf-ransac"));
    assertEquals(
        List.of(FeatureDetector.ORB, FeatureDetector.SURF),
        Detectors.features(List.of("orb-located", "surf", "orb")));
    assertEquals(List.of(), Detectors.boxes(List.of("orb-located", "sift")));
  }

  private double confidence(MatchReading reading, Patch patch) {
    Features from = new Features(template, new Mat());
    return reading.confidence(from, new Features(photo, new Mat()), matches, patch);
  }
}
