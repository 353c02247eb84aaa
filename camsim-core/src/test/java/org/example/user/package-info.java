/** A minimal implementation of each extension point, as in the jar of a user. */
package org.example.user;
