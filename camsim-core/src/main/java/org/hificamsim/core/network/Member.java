package org.hificamsim.core.network;

import org.hificamsim.core.network.agent.Agent;
import org.hificamsim.core.network.auction.Trader;
import org.hificamsim.core.network.bandit.ScheduleSwitch;
import org.hificamsim.core.network.bandit.ZoomBandit;

/**
 * A camera in the network with all that belongs to it.
 *
 * @param switching its bandit of schedules, or null
 * @param zooming its bandit of ranges, or null
 */
record Member(Agent agent, Trader trader, ScheduleSwitch switching, ZoomBandit zooming) {}
