package org.hificamsim.network;

import java.util.Optional;
import org.hificamsim.network.bandit.BanditKind;

/**
 * What one camera is to be in the network.
 *
 * @param comm the policy's number in CamSim, 4 for one named by its class
 * @param frozen whether its links neither fade nor grow
 * @param reverseLinks whether it is linked to those that list it, too
 */
public record AgentSetup(
    ScheduleKind schedule,
    PolicyKind policy,
    int comm,
    int limit,
    Optional<BanditKind> bandit,
    boolean frozen,
    boolean reverseLinks) {}
