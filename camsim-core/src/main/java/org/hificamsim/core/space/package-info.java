/** Points of the plane, sorted by position. */
package org.hificamsim.core.space;
