package badlog.release

import java.io.File

/** The project's top folder. */
internal val ROOT: File = generateSequence(File("").absoluteFile) { it.parentFile }.first { File(it, "settings.gradle.kts").exists() }

/** Returns the value of [name] in gradle.properties. */
internal fun property(name: String): String = File(ROOT, "gradle.properties").readLines().first { it.startsWith("$name=") }.substringAfter('=')

/** The version of this project. */
internal val VERSION: String = property("version")
