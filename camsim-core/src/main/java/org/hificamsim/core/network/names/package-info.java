/**
 * Names of schedules, policies and bandits: those of old scenario files, of today, and short ones.
 */
package org.hificamsim.core.network.names;
