/** Where to put the cameras. */
package org.hificamsim.placement;
