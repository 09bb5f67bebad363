"""The QGIS plugin of Talus: a provider of Processing that drives the program `talus` through project files."""


def classFactory(iface):
    from .plugin import TalusPlugin

    return TalusPlugin()
