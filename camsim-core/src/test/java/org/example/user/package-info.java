/** What a user's own jar holds: the least that each extension point asks for. */
package org.example.user;
