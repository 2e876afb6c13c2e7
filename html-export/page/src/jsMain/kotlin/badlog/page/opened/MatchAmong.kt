package badlog.page.opened

import badlog.formats.driverstation.DriverStationFormat
import badlog.formats.revlog.RevlogFormat
import badlog.page.reading.MatchFiles
import badlog.page.reading.filesInZip
import badlog.signals.match.files.MatchManifest
import org.w3c.files.File
import kotlin.js.Promise

/** Returns whether [file] is named like a ZIP. */
internal fun isZip(file: File): Boolean = file.name.endsWith(".zip", ignoreCase = true)

/** Returns whether [file] is named like a manifest, and is not in a folder of a folder. */
internal fun isManifest(file: File): Boolean = file.name == MatchManifest.NAME && OpenedLog.pathOf(file).count { it == '/' } <= 1

/**
 * Promises the logs of the match in [zip]. Rejected with a sentence, see [filesInZip], or if it has several manifests or one with a
 * mistake.
 */
internal fun matchInZip(zip: File): Promise<MatchFiles> =
    filesInZip(zip) { it.substringAfterLast('/') == MatchManifest.NAME || OpenedLog.isNamedLikeLog(it) }.then { content ->
        matchOf(content.files, content.names).then { it ?: MatchFiles(logsOf(content.files), null, content.names.toSet()) }
    }.unsafeCast<Promise<MatchFiles>>()

/** Promises the logs that a manifest among [files] names; null if there is no manifest. Rejected with a sentence if it has a mistake. */
internal fun matchAmong(files: List<File>): Promise<MatchFiles?> = matchOf(files, files.map(OpenedLog::pathOf)).then { match ->
    match?.run {
        val named = MatchManifest.of(manifest.orEmpty()).files.mapTo(HashSet()) { it.name }
        MatchFiles(logs.filterKeys(named::contains), manifest, names)
    }
}

/**
 * Returns the logs of a match among [files], which were given together: one robot's log, by which the match is named, and logs of other
 * devices. Null if they are not.
 */
internal fun matchTogether(files: List<File>): Pair<String, MatchFiles>? {
    val paths = files.map(OpenedLog::pathOf).filter(OpenedLog::isNamedLikeLog)
    val robot = paths.singleOrNull { path -> OF_DEVICES.none { path.endsWith(it, ignoreCase = true) } }
    if (robot == null || paths.size == 1 || paths.any { '/' in it }) return null
    val logs = logsOf(files)
    return robot.substringBeforeLast('.') to MatchFiles(logs, null, logs.keys)
}

private val OF_DEVICES = DriverStationFormat.endings + RevlogFormat.endings

private fun matchOf(files: List<File>, paths: List<String>): Promise<MatchFiles?> {
    val named = files.filter { it.name == MatchManifest.NAME }
    return Promise.all(named.map { it.asDynamic().text().unsafeCast<Promise<String>>() }.toTypedArray()).then { texts ->
        val manifests = named.zip(texts).filter { (_, text) -> MatchManifest.isOne(text) }
        if (manifests.size > 1) throw Error("It has several ${MatchManifest.NAME}; open the files of one match.")
        manifests.singleOrNull()?.let { (file, text) ->
            // A mistake is said before anything is read.
            MatchManifest.of(text)
            val folder = OpenedLog.pathOf(file).removeSuffix(MatchManifest.NAME)
            fun beside(path: String) = if (path.startsWith(folder)) path.removePrefix(folder) else "../$path"
            MatchFiles(logsOf(files).mapKeys { beside(it.key) }, text, paths.mapTo(HashSet(), ::beside))
        }
    }
}

private fun logsOf(files: List<File>) = OpenedLog.logsIn(files.filter(OpenedLog::isNamedLikeLog)).associate { it.path to it.files }
