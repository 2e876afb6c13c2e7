package badlog.page

import java.util.Base64

/**
 * A script for a page in whose browser a person chooses a folder called `pit` with [files], into which the page may look again: without the
 * seconds between two looks, which no test needs.
 */
internal fun watchedFolder(files: Map<String, ByteArray>): String = "$OFTEN${putIntoFolder(files)}" +
    "window.showDirectoryPicker = async () => ({name: 'pit', values: async function* () {" +
    "for (const [name, file] of Object.entries(window.folder)) yield {kind: 'file', name, getFile: async () => file} }})"

/** A script after which that folder has [files], and no others. */
internal fun putIntoFolder(files: Map<String, ByteArray>): String = "window.folder = {${files.entries.joinToString { (name, bytes) ->
    "'$name': new File([Uint8Array.from(atob('${Base64.getEncoder().encodeToString(bytes)}'), c => c.charCodeAt(0))], '$name', {lastModified: 1})"
}}};"

/** Makes the page look after a quarter of a second, in which its list has shown what was found before. Its notices stay as long as ever. */
private const val OFTEN = "{ const set = window.setTimeout; window.keepsTime = true;" +
    "window.setTimeout = (work, delay, ...more) => set(work, delay >= 1000 && delay < 4000 ? 250 : delay, ...more) }"
