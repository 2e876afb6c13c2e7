package badlog.page

import java.util.Base64

/**
 * Returns a script that gives the page a folder `pit` with [files], into which it may look again. It looks without the pause of some
 * seconds, which no test needs.
 */
internal fun watchedFolder(files: Map<String, ByteArray>): String = "$OFTEN${putIntoFolder(files)}" +
    "window.showDirectoryPicker = async () => ({name: 'pit', values: async function* () {" +
    "for (const [name, file] of Object.entries(window.folder)) yield {kind: 'file', name, getFile: async () => file} }})"

/** Returns a script after which that folder contains exactly [files]. */
internal fun putIntoFolder(files: Map<String, ByteArray>): String = "window.folder = {${files.entries.joinToString { (name, bytes) ->
    "'$name': new File([Uint8Array.from(atob('${Base64.getEncoder().encodeToString(bytes)}'), c => c.charCodeAt(0))], '$name', {lastModified: 1})"
}}};"

/** Makes the page look after a quarter of a second, in which its list has shown earlier results. Its notices stay as long as usual. */
private const val OFTEN = "{ const set = window.setTimeout; window.keepsTime = true;" +
    "window.setTimeout = (work, delay, ...more) => set(work, delay >= 1000 && delay < 4000 ? 250 : delay, ...more) }"
