package org.hificamsim.network;

import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.auction.Trader;
import org.hificamsim.network.bandit.ScheduleSwitch;
import org.hificamsim.network.bandit.ZoomBandit;

/**
 * A camera in the network with all that belongs to it.
 *
 * @param switching its bandit of schedules, or null
 * @param zooming its bandit of ranges, or null
 */
record Member(Agent agent, Trader trader, ScheduleSwitch switching, ZoomBandit zooming) {}
