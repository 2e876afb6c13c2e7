package badlog.site.api

import org.jetbrains.dokka.DokkaConfiguration
import org.jetbrains.dokka.DokkaConfigurationImpl
import org.jetbrains.dokka.DokkaGenerator
import org.jetbrains.dokka.DokkaSourceSetID
import org.jetbrains.dokka.DokkaSourceSetImpl
import org.jetbrains.dokka.Platform
import org.jetbrains.dokka.PluginConfigurationImpl
import org.jetbrains.dokka.utilities.DokkaConsoleLogger
import org.jetbrains.dokka.utilities.LoggingLevel
import java.io.File

/**
 * Writes the pages of the API with Dokka. Arguments: the target folder, the class path of the libraries, then the folders of their sources.
 */
internal fun main(args: Array<String>) {
    val target = File(args[0])
    val classPath = args[1].split(File.pathSeparator).map(::File)
    val sources = args.drop(2).map(::File).filter { it.exists() }.toSet()
    target.deleteRecursively()
    val configuration = DokkaConfigurationImpl(
        moduleName = "badlog",
        outputDir = target,
        offlineMode = true,
        suppressObviousFunctions = true,
        suppressInheritedMembers = true,
        sourceSets = listOf(
            DokkaSourceSetImpl(
                displayName = "JVM",
                sourceSetID = DokkaSourceSetID("badlog", "main"),
                classpath = classPath,
                sourceRoots = sources,
                suppressedFiles = actualsIn(sources),
                skipEmptyPackages = true,
                jdkVersion = 17,
                noStdlibLink = true,
                noJdkLink = true,
                analysisPlatform = Platform.jvm,
            ),
        ),
        pluginsConfiguration = listOf(
            PluginConfigurationImpl(
                fqPluginName = "org.jetbrains.dokka.base.DokkaBase",
                serializationFormat = DokkaConfiguration.SerializationFormat.JSON,
                values = """{"homepageLink": "$HOME", "footerMessage": "badlog, MIT license"}""",
            ),
        ),
    )
    DokkaGenerator(configuration, DokkaConsoleLogger(LoggingLevel.WARN)).generate()
    makeOffline(target)
}

/** Returns the files with the JVM's implementations of expected declarations, which the common sources already describe. */
private fun actualsIn(sources: Set<File>): Set<File> =
    sources.flatMap { it.walk() }.filter { it.extension == "kt" && ACTUAL.containsMatchIn(it.readText()) }.toSet()

private val ACTUAL = Regex("""(?m)^(public |internal )?actual """)
