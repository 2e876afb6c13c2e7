package badlog.page

import java.util.Base64

/** A script for a page in whose browser a person chooses a folder called `pit` with [files], into which the page may look again. */
internal fun watchedFolder(files: Map<String, ByteArray>): String = "window.keepsTime = true; ${putIntoFolder(files)}" +
    "window.showDirectoryPicker = async () => ({name: 'pit', values: async function* () {" +
    "for (const [name, file] of Object.entries(window.folder)) yield {kind: 'file', name, getFile: async () => file} }})"

/** A script after which that folder has [files], and no others. */
internal fun putIntoFolder(files: Map<String, ByteArray>): String = "window.folder = {${files.entries.joinToString { (name, bytes) ->
    "'$name': new File([Uint8Array.from(atob('${Base64.getEncoder().encodeToString(bytes)}'), c => c.charCodeAt(0))], '$name', {lastModified: 1})"
}}};"
