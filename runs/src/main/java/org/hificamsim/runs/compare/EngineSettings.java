package org.hificamsim.runs.compare;

import java.util.Optional;
import org.hificamsim.catalogue.Catalogue;

/**
 * The place where runs are computed. No result depends on it.
 *
 * @param catalogue the catalogue of this process
 * @param threads the number of threads of this machine to use, 1 or more
 * @param master the URL of a cluster's master, if given
 */
public record EngineSettings(Catalogue catalogue, int threads, Optional<String> master) {}
