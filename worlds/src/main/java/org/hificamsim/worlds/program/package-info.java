/** Policies that decide in a program of their own, which gets nothing but what cameras know. */
package org.hificamsim.worlds.program;
