package org.hificamsim.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.hificamsim.bridge.camsim.Requirements;
import org.hificamsim.bridge.camsim.Use;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class ShapeTest {
  private static final Set<Use> ALL = EnumSet.allOf(Use.class);
  private static final Set<Use> DETECTING = EnumSet.of(Use.READ, Use.DETECT);
  private static final String LOOK =
      "method CameraController.update_visiblity(TraceableObject) returning double";
  private static final String CHANGE =
      "method CameraController.change(double, double, double, double, double)";

  @TempDir Path folder;

  @Test
  void theDoublesHaveItAll() throws IOException {
    assertEquals(List.of(), missing(ALL, CamSimRun.DOUBLES));
  }

  @ParameterizedTest
  @MethodSource
  void whatIsMissingOrOtherwiseIsNamed(String text, String replacement, String missing)
      throws IOException {
    List<String> found = missing(ALL, Variant.of(folder, text, replacement));
    assertTrue(found.contains(missing), found.toString());
  }

  static Stream<Arguments> whatIsMissingOrOtherwiseIsNamed() {
    return Stream.of(
        arguments("update_visiblity", "update_visibility", LOOK),
        arguments("double update_visiblity", "Double update_visiblity", LOOK),
        arguments(
            "addVisibleObject",
            "show",
            "method CameraController.addVisibleObject(TraceableObject, double)"),
        arguments(
            "removeVisibleObject",
            "hide",
            "method CameraController.removeVisibleObject(TraceableObject)"),
        arguments("change(", "alter(", CHANGE),
        arguments("getHeading", "heading", "method CameraController.getHeading() returning double"),
        arguments("getY", "ordinate", "method TraceableObject.getY() returning double"),
        arguments("getFeatures", "features", "method TraceableObject.getFeatures()"),
        arguments("SimCore", "OtherCore", "class SimCore"),
        arguments("TraceableObject", "Thing", "class TraceableObject"),
        arguments("update()", "advance()", "method SimCore.update()"),
        arguments("close_files", "finish", "method SimCore.close_files()"));
  }

  @Test
  void whatIsNotNeededMayBeMissing() throws IOException {
    Path classes = Variant.of(folder, "change(", "alter(");
    assertEquals(List.of(), missing(DETECTING, classes));
    assertEquals(List.of(CHANGE), missing(ALL, classes));
  }

  /** What is missing, without the package's name. */
  private static List<String> missing(Set<Use> uses, Path classes) throws IOException {
    URL[] path = {classes.toUri().toURL()};
    try (URLClassLoader loader = new URLClassLoader(path, null)) {
      return Requirements.missing(uses, loader).stream()
          .map(name -> name.replace("epics.camsim.core.", ""))
          .toList();
    }
  }
}
