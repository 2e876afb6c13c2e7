package badlog.viewer.app

/** Opens what [start] names, when the window begins. */
internal fun openFirst(viewer: Viewer, start: StartPlace) {
    start.complaint?.let { viewer.notices.complain(it) }
    start.folder?.let { viewer.libraryFolder.open(it, showsNewest = start.file == null) }
    start.file?.let { viewer.loading.open(it) }
}
