package org.hificamsim.profiling.dataset;

import java.nio.file.Path;
import java.util.Optional;

/**
 * One picture of one object: a row of {@code dataset.csv}.
 *
 * @param image its name in the table
 * @param file the picture
 * @param object the object's name
 * @param size q, metres
 * @param distance d, metres
 * @param focalLength z, metres
 * @param patch where the object is
 * @param mask a picture that is not 0 where the object is
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
