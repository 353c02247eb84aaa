/** Exact areas of fields of view. */
package org.hificamsim.core.network.geometry;
