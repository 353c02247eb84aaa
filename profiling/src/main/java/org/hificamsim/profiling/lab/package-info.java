/**
 * The rendered laboratory of thesis 3.5: a room, textured objects and a camera, all from one seed.
 */
package org.hificamsim.profiling.lab;
