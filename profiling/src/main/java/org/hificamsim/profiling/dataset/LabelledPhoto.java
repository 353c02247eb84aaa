package org.hificamsim.profiling.dataset;

import java.nio.file.Path;
import java.util.Optional;

/**
 * One picture of one object: a row of {@code dataset.csv}.
 *
 * @param image the picture's name in the table
 * @param file the picture file
 * @param object the object's name
 * @param size q, in metres
 * @param distance d, in metres
 * @param focalLength z, in metres
 * @param patch the rectangle around the object
 * @param mask a picture whose pixels are not 0 on the object
 */
public record LabelledPhoto(
    String image,
    Path file,
    String object,
    double size,
    double distance,
    double focalLength,
    Patch patch,
    Optional<Path> mask) {}
