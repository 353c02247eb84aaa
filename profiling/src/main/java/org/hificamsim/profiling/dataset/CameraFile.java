package org.hificamsim.profiling.dataset;

import java.nio.file.Path;
import org.hificamsim.core.InputException;
import org.hificamsim.hifi.json.JsonFile;
import org.hificamsim.hifi.json.JsonObject;

/** Reads {@code camera.json}. */
final class CameraFile {
  private static final int MAX_PIXELS = 100_000;
  private static final int MAX_BYTES = 1 << 20;

  private CameraFile() {}

  /**
   * The camera.
   *
   * @throws InputException with its place, when the file is missing or wrong
   */
  static PhotoCamera read(Path file) {
    return JsonFile.read(file, "the camera's sensor and pixels", MAX_BYTES)
        .whole(CameraFile::camera);
  }

  private static PhotoCamera camera(JsonObject json) {
    return new PhotoCamera(
        json.number("sensorWidth", 1e-6, 1),
        json.number("sensorHeight", 1e-6, 1),
        (int) json.number("width", 1, MAX_PIXELS),
        (int) json.number("height", 1, MAX_PIXELS));
  }
}
