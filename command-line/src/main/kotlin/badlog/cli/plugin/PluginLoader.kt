package badlog.cli.plugin

import badlog.cli.command.ExitCode
import badlog.cli.console.Console
import badlog.exporter.BADLOG_VERSION
import java.net.URLClassLoader
import java.nio.file.Files
import java.nio.file.Path
import java.util.ServiceConfigurationError
import java.util.ServiceLoader
import kotlin.io.path.extension
import kotlin.io.path.listDirectoryEntries

/**
 * Finds commands with large libraries that most people never use. They are services, such as [McpService], in jars in a separate folder. A
 * separate class loader loads them when one of them is called.
 *
 * @param program the loader of the program's classes. A service found there, as when Gradle runs it, takes precedence.
 * @param folder the folder of the jars, used for all other services.
 */
internal class PluginLoader(private val program: ClassLoader, private val folder: Path) {
    /**
     * Calls [command] by passing its service to [work].
     *
     * @return the result; [ExitCode.NOTHING] if the service is missing. Then [console] reports how to get it.
     */
    fun <S : Any> call(command: String, service: Class<S>, console: Console, work: (S) -> ExitCode): ExitCode {
        val (loader, found) = find(service) ?: run {
            console.warn(
                "badlog $command needs badlog's part “${folder.fileName}”, but the folder $folder is missing or incomplete; " +
                    "unpack badlog-${folder.fileName}-$BADLOG_VERSION.zip where badlog was unpacked.",
            )
            return ExitCode.NOTHING
        }
        val thread = Thread.currentThread()
        val before = thread.contextClassLoader
        // Libraries use it to find their own parts.
        thread.contextClassLoader = loader
        try {
            return work(found)
        } finally {
            thread.contextClassLoader = before
        }
    }

    private fun <S : Any> find(service: Class<S>): Pair<ClassLoader, S>? =
        sequenceOf({ program }, ::loaderOfFolder).mapNotNull { it() }.firstNotNullOfOrNull { loader ->
            try {
                ServiceLoader.load(service, loader).firstOrNull()?.let { loader to it }
            } catch (_: ServiceConfigurationError) {
                null
            }
        }

    private fun loaderOfFolder(): ClassLoader? {
        if (!Files.isDirectory(folder)) return null
        return PluginClassLoader(folder.listDirectoryEntries().filter { it.extension == "jar" }.sorted(), program)
    }

    companion object {
        /** The folder beside the program's jars. */
        const val FOLDER = "season"

        /** Returns the loader for the parts of the running program. */
        fun ofProgram(): PluginLoader {
            val jar = Path.of(PluginLoader::class.java.protectionDomain.codeSource.location.toURI())
            return PluginLoader(PluginLoader::class.java.classLoader, jar.resolveSibling(FOLDER))
        }
    }
}

/**
 * Loads classes from [jars] before [program], so that a part may have other versions of libraries than the program. Only Java,
 * Kotlin and badlog itself come from the program, because both communicate through them. Java's classes come from Java, even if a jar also has
 * them, such as the interfaces of XML: their objects come from Java as well.
 */
private class PluginClassLoader(jars: List<Path>, private val program: ClassLoader) :
    URLClassLoader("part", jars.map { it.toUri().toURL() }.toTypedArray(), program) {
    override fun loadClass(name: String, resolve: Boolean): Class<*> = synchronized(getClassLoadingLock(name)) {
        findLoadedClass(name) ?: if (SHARED.any(name::startsWith)) super.loadClass(name, resolve) else ownOrShared(name)
    }

    private fun ownOrShared(name: String): Class<*> =
        sequenceOf(ClassLoader.getPlatformClassLoader()::loadClass, ::findClass).firstNotNullOfOrNull { find ->
            try {
                find(name)
            } catch (_: ClassNotFoundException) {
                null
            }
        } ?: program.loadClass(name)

    private companion object {
        val SHARED = listOf("java.", "kotlin.", "badlog.")
    }
}
