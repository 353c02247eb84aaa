package org.hificamsim.profiling.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.check.Calibration.Lens;
import org.hificamsim.profiling.check.Calibration.Pixel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests projections of points by synthetic cameras, and back to the ground. */
class CalibrationTest {
  @Test
  void levelCameraProjectsLikeAPinhole() {
    Calibration camera = MadeCameras.at(5, 0, MadeCameras.LENS);
    Pixel foot = camera.project(new Vector3D(2, 20, 0));
    assertEquals(384 + 6 * 1.25 / 0.01 * 2 / 20, foot.u(), 1e-9);
    assertEquals(288 + 6 / 0.012 * 5 / 20, foot.v(), 1e-9);
    assertEquals(500, camera.focalLength(), 1e-9);
    assertEquals(5, camera.position().getZ(), 1e-9);
    assertEquals(288, camera.project(new Vector3D(0, 1e6, 5)).v(), 1e-9, "the horizon");
    assertTrue(Double.isNaN(camera.project(new Vector3D(0, -3, 0)).u()), "behind it");
  }

  @Test
  void rotatesAboutXThenYThenZ() {
    Lens plain = new Lens(1, 0, 1, 1, 1, 0, 0);
    Vector3D away = new Vector3D(0, 0, 5);
    double quarter = Math.PI / 2;
    Calibration camera =
        Calibration.tsai(new Vector3D(quarter, quarter, 0), away, plain, MadeCameras.PICTURE);
    Pixel north = camera.project(new Vector3D(0, 1, 0)); // about x: to z; about y: z to x
    assertEquals(1.0 / 5, north.u(), 1e-12);
    assertEquals(0, north.v(), 1e-12);
    Calibration last =
        Calibration.tsai(new Vector3D(0, quarter, quarter), away, plain, MadeCameras.PICTURE);
    Pixel up = last.project(new Vector3D(0, 0, 1)); // about y: to x; about z: x to y
    assertEquals(1.0 / 5, up.v(), 1e-12);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.005, -0.002})
  void groundInvertsProjection(double kappa1) {
    Calibration camera = MadeCameras.at(6, 15, MadeCameras.bent(kappa1));
    for (double x = -6; x <= 6; x += 1.5) {
      for (double y = 12; y <= 40; y += 4) {
        Vector3D back = camera.ground(camera.project(new Vector3D(x, y, 0)));
        assertEquals(x, back.getX(), 1e-6);
        assertEquals(y, back.getY(), 1e-6);
        assertEquals(0, back.getZ(), 1e-9);
      }
    }
    assertTrue(Double.isNaN(camera.ground(new Pixel(384, -400)).getX()), "above the horizon");
  }

  @Test
  void distortionMovesPointsFarFromTheCentre() {
    Calibration bent = MadeCameras.at(5, 0, MadeCameras.bent(0.01));
    Pixel seen = bent.project(new Vector3D(8, 20, 5));
    double r = (seen.u() - 384) * 0.01 / 1.25; // in millimetres
    assertEquals(6.0 * 8 / 20, r * (1 + 0.01 * r * r), 1e-9);
  }

  @ParameterizedTest
  @CsvSource({"1, 1", "0.001, 1", "1, -3.5", "0.01, 0.02"})
  void matrixScaleAndUnitDoNotMatter(double metres, double scale) {
    Calibration camera = MadeCameras.at(6, 15, MadeCameras.LENS);
    Calibration matrix =
        Calibration.matrix(MadeCameras.matrix(6, 15, metres, scale), metres, MadeCameras.PICTURE);
    Vector3D point = new Vector3D(3, 17, 1.2);
    assertEquals(0, camera.project(point).distance(matrix.project(point)), 1e-6);
    Vector3D ground = matrix.ground(camera.project(new Vector3D(-2, 25, 0)));
    assertEquals(-2, ground.getX(), 1e-6);
    assertEquals(25, ground.getY(), 1e-6);
    assertEquals(6, matrix.position().getZ(), 1e-6);
    assertEquals(500, matrix.focalLength(), 1e-6);
    assertTrue(Double.isNaN(matrix.project(new Vector3D(0, -9, 0)).u()), "behind it");
  }

  @Test
  void rejectsSingularMatrix() {
    double[] flat = {1, 0, 0, 0, 2, 0, 0, 0, 0, 0, 1, 1};
    InputException refused =
        assertThrows(InputException.class, () -> Calibration.matrix(flat, 1, MadeCameras.PICTURE));
    assertTrue(refused.getMessage().contains("not a camera's"), refused.getMessage());
  }
}
