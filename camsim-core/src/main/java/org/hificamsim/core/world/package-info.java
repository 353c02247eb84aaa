/** The world's state in flat arrays: field, cameras, targets, and how they change. */
package org.hificamsim.core.world;
