/** Points of the plane and what is near them. */
package org.hificamsim.core.space;
