package org.hificamsim.profiling.check;

import java.nio.file.Path;
import java.util.Optional;
import org.hificamsim.tracks.format.Unit;

/**
 * What is compared with what.
 *
 * @param boxes a MOT file
 * @param unit of its positions in the world
 * @param calibration by Tsai's method or a matrix
 * @param calibrationUnit of its world, where somebody says
 * @param image the picture's size, where somebody says
 * @param body what targets are assumed to be like
 */
public record CheckSettings(
    Path boxes,
    Unit unit,
    Path calibration,
    Optional<Unit> calibrationUnit,
    Optional<ImageSize> image,
    Body body) {}
