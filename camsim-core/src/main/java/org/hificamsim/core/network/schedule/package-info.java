/** Auction schedules: when a camera sells, and what targets are worth to it. */
package org.hificamsim.core.network.schedule;
