/** Pictures and animations of recorded runs, painted without a browser or a display. */
package org.hificamsim.presentation.picture;
