/** Policies that decide in a program of their own, which gets only what cameras know. */
package org.hificamsim.worlds.program;
