package org.hificamsim.network;

import java.util.Optional;
import org.hificamsim.network.agent.ScheduleKind;
import org.hificamsim.network.bandit.BanditAlgorithm;

/**
 * What one camera is in the network.
 *
 * @param limit number of targets owned from which on it claims no other; 0 for no limit
 */
record CameraRole(ScheduleKind schedule, Comm comm, int limit, Optional<BanditAlgorithm> bandit) {}
