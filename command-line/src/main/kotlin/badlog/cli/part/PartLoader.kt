package badlog.cli.part

import badlog.cli.command.ExitCode
import badlog.cli.console.Console
import badlog.html.BADLOG_VERSION
import java.net.URLClassLoader
import java.nio.file.Files
import java.nio.file.Path
import java.util.ServiceConfigurationError
import java.util.ServiceLoader
import kotlin.io.path.extension
import kotlin.io.path.listDirectoryEntries

/**
 * Finds the commands whose libraries would weigh on those who never call them. They are services, such as [McpService], in jars of
 * a folder of their own, and get a class loader of their own when one of them is called.
 *
 * @param program where the program's classes come from. What provides a service there, as when Gradle runs it, is taken first.
 * @param folder where the jars are otherwise.
 */
internal class PartLoader(private val program: ClassLoader, private val folder: Path) {
    /**
     * Calls [command] by giving its service to [work].
     *
     * @return what came of it; [ExitCode.NOTHING] where the service is missing, which is reported to [console] with how to get it.
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
        // Libraries look for their own parts by it.
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
        return PartClassLoader(folder.listDirectoryEntries().filter { it.extension == "jar" }.sorted(), program)
    }

    companion object {
        /** The folder beside the program's jars. */
        const val FOLDER = "season"

        /** Where the program that runs has its parts. */
        fun ofProgram(): PartLoader {
            val jar = Path.of(PartLoader::class.java.protectionDomain.codeSource.location.toURI())
            return PartLoader(PartLoader::class.java.classLoader, jar.resolveSibling(FOLDER))
        }
    }
}

/**
 * Loads classes from [jars] before it asks [program] for them, so that a part may have other versions of libraries than the program;
 * only Java, Kotlin and badlog itself are the program's, since both talk with each other by them.
 */
private class PartClassLoader(jars: List<Path>, private val program: ClassLoader) :
    URLClassLoader("part", jars.map { it.toUri().toURL() }.toTypedArray(), program) {
    override fun loadClass(name: String, resolve: Boolean): Class<*> = synchronized(getClassLoadingLock(name)) {
        findLoadedClass(name) ?: if (SHARED.any(name::startsWith)) super.loadClass(name, resolve) else ownOrShared(name)
    }

    private fun ownOrShared(name: String): Class<*> = try {
        findClass(name)
    } catch (_: ClassNotFoundException) {
        program.loadClass(name)
    }

    private companion object {
        val SHARED = listOf("java.", "kotlin.", "badlog.")
    }
}
